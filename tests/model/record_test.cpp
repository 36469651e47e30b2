// Copyright the limpet authors. GPL-3.0-or-later.
//
// Records that no model can be made of: each is refused with the reason, and none is taken for another model.
#include <gtest/gtest.h>

#include <limits>

#include "../not_finite.hpp"
#include "streams.hpp"

namespace limpet::model {
namespace {

struct Damage {
  const char* says;
  std::function<void(ModelRecord&)> change;
};

std::string refusal_of(const ModelRecord& record) {
  try {
    const Model model(record);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// Half a cube's points: polygons that share edges, mature and young, and point segments.
const ModelRecord& whole() {
  static const ModelRecord record = [] {
    const testing::Scan scan =
        testing::scanned("cube", 1200, 0.0005, simulation::ScanOptions::Order::shuffled);
    Model model(scan.parameters);
    model.update(scan.points);
    model.finish();
    model.update(std::vector<SensorPoint>{{{5, 5, 5}, {0, 0, -1}, 0}, {{5, 5.001, 5}, {0, 0, -1}, 0}});
    return model.record();
  }();
  return record;
}

PolygonSegmentRecord& polygon(ModelRecord& r) { return r.polygon_segments.front(); }
PointSegmentRecord& point(ModelRecord& r) { return r.point_segments.front(); }
VertexRecord& vertex(ModelRecord& r) { return polygon(r).cycles.front()[1]; }

TEST(Record, AModelIsMadeOfOneThatIsWhole) {
  ASSERT_FALSE(whole().polygon_segments.empty());
  ASSERT_FALSE(whole().point_segments.empty());
  ASSERT_FALSE(whole().point_segments.front().raw.empty());
  EXPECT_EQ(refusal_of(whole()), "");
  EXPECT_EQ(testing::bytes(Model(whole()).record()), testing::bytes(whole()));
  ModelRecord many = whole();  // so many that 2^96 for each would not fit 128 bits
  polygon(many).moments.count = std::int64_t{1} << 40;
  EXPECT_EQ(refusal_of(many), "");
}

TEST(Record, WhatIsNotFiniteOrBeyondTheGridIsRefused) {
  const std::vector<std::function<double&(ModelRecord&)>> reals = {
      [](ModelRecord& r) -> double& { return r.parameters.resolution; },
      [](ModelRecord& r) -> double& { return r.parameters.resolution_per_range; },
      [](ModelRecord& r) -> double& { return r.parameters.angle_rad; },
      [](ModelRecord& r) -> double& { return r.parameters.noise; },
      [](ModelRecord& r) -> double& { return r.parameters.noise_per_range; },
      [](ModelRecord& r) -> double& { return r.parameters.noise_per_range2; },
      [](ModelRecord& r) -> double& { return r.parameters.input_quantum; },
      [](ModelRecord& r) -> double& { return r.parameters.tolerance; },
      [](ModelRecord& r) -> double& { return r.parameters.redundancy_count; },
      [](ModelRecord& r) -> double& { return r.parameters.redundancy_ratio; },
      [](ModelRecord& r) -> double& { return r.grid_step; },
      [](ModelRecord& r) -> double& { return polygon(r).axis_sum.y(); },
      [](ModelRecord& r) -> double& { return polygon(r).variance_sum; },
      [](ModelRecord& r) -> double& { return polygon(r).chart_origin.x(); },
      [](ModelRecord& r) -> double& { return polygon(r).chart_u.x(); },
      [](ModelRecord& r) -> double& { return polygon(r).chart_v.y(); },
      [](ModelRecord& r) -> double& { return polygon(r).chart_normal.z(); },
      [](ModelRecord& r) -> double& { return polygon(r).height[0]; },
      [](ModelRecord& r) -> double& { return polygon(r).height[1]; },
      [](ModelRecord& r) -> double& { return polygon(r).height[2]; },
      [](ModelRecord& r) -> double& { return polygon(r).initial_centroid.z(); },
      [](ModelRecord& r) -> double& { return polygon(r).initial_normal.x(); },
      [](ModelRecord& r) -> double& { return vertex(r).x; },
      [](ModelRecord& r) -> double& { return vertex(r).y; },
      [](ModelRecord& r) -> double& { return point(r).axis_sum.x(); },
      [](ModelRecord& r) -> double& { return point(r).variance_sum; },
      [](ModelRecord& r) -> double& { return point(r).raw.front().axis.z(); },
  };
  for (std::size_t i = 0; i < reals.size(); ++i)
    for (const double value : {kNaN, kInfinity, -kInfinity}) {
      ModelRecord damaged = whole();
      reals[i](damaged) = value;
      EXPECT_NE(refusal_of(damaged), "") << "number " << i << ": " << value;
    }
  for (std::size_t i = 11; i < reals.size(); ++i)
    for (const double value : {1e20, -1e30, 1e300}) {
      if (i == 12 || i == 25) continue;  // a variance may be any
      ModelRecord damaged = whole();
      reals[i](damaged) = value;
      EXPECT_NE(refusal_of(damaged), "") << "number " << i << ": " << value;
    }
}

TEST(Record, TheReasonIsSaid) {
  const std::int64_t far = (std::int64_t{1} << 48) + 1;
  const std::vector<Damage> damages = {
      {"grid step", [](ModelRecord& r) { r.grid_step *= 2; }},
      {"a count is", [](ModelRecord& r) { r.points = -1; }},
      {"a count is", [](ModelRecord& r) { r.sets = std::numeric_limits<std::int64_t>::max(); }},
      {"next identities", [](ModelRecord& r) { r.next_edge = std::numeric_limits<std::uint64_t>::max(); }},
      {"identity that was not given", [](ModelRecord& r) { polygon(r).id = 0; }},
      {"identity that was not given", [](ModelRecord& r) { point(r).id = r.next_segment; }},
      {"is there twice", [](ModelRecord& r) { polygon(r).id = point(r).id; }},
      {"edge of an identity that was not given", [](ModelRecord& r) { vertex(r).edge = 0; }},
      {"edge of an identity that was not given", [](ModelRecord& r) { vertex(r).edge = r.next_edge; }},
      {"edge whose identity occurs twice",
       [](ModelRecord& r) { vertex(r).edge = r.polygon_segments.back().cycles.front().front().edge; }},
      {"has no partner", [](ModelRecord& r) { vertex(r).partner = vertex(r).edge; }},
      // As a number damaged in a file did it: the neighbour's plane became that of the polygon itself.
      {"is between parallel planes",
       [](ModelRecord& r) {
         for (auto& other : r.polygon_segments) {
           other.chart_u = polygon(r).chart_u, other.chart_v = polygon(r).chart_v;
           other.chart_normal = polygon(r).chart_normal;
           other.height = {0, 0, 0};
         }
       }},
      {"no grid point within 2^40", [](ModelRecord& r) { vertex(r).x += 0.5; }},
      {"no grid point within 2^40", [](ModelRecord& r) { vertex(r).y = 0x1p41; }},
      {"sums that no points have", [](ModelRecord& r) { point(r).moments.sum[1] = Int128{1} << 127; }},
      {"sums that no points have",
       [](ModelRecord& r) { point(r).moments.sum[1] = Int128{far} * point(r).moments.count; }},
      {"too many points", [](ModelRecord& r) { polygon(r).moments.product[2] = Int128{1} << 127; }},
      {"too many points",
       [](ModelRecord& r) { polygon(r).moments.count = std::numeric_limits<std::int64_t>::max(); }},
      {"fewer than no points", [](ModelRecord& r) { polygon(r).moments.count = -1; }},
      {"has no points",
       [](ModelRecord& r) {
         point(r) = {point(r).id, {}, {0, 0, 0}, {}, 0};
       }},
      {"other sensor points than it counts", [](ModelRecord& r) { ++point(r).moments.count; }},
      {"beyond 2^48 grid steps", [=](ModelRecord& r) { point(r).raw.front().at[2] = -far; }},
      {"returned less than never", [](ModelRecord& r) { point(r).raw.front().returned = -1; }},
      {"axis is no unit vector", [](ModelRecord& r) { point(r).raw.front().axis *= 2; }},
      {"axis sum", [](ModelRecord& r) { polygon(r).axis_sum *= 3; }},
      {"variance", [](ModelRecord& r) { polygon(r).variance_sum = -1; }},
      {"orthonormal", [](ModelRecord& r) { polygon(r).chart_u = polygon(r).chart_v; }},
      {"orthonormal", [](ModelRecord& r) { polygon(r).chart_normal *= -1; }},
      {"more than 3 degrees", [](ModelRecord& r) { polygon(r).height[1] = 0.06; }},
      {"initial plane", [](ModelRecord& r) { polygon(r).initial_normal.setZero(); }},
      {"a count", [](ModelRecord& r) { polygon(r).confirmed = -1; }},
      {"confirmed", [](ModelRecord& r) { polygon(r).confirmed = 1; }},
  };
  for (const Damage& damage : damages) {
    ModelRecord damaged = whole();
    damage.change(damaged);
    const std::string refusal = refusal_of(damaged);
    EXPECT_NE(refusal.find(damage.says), std::string::npos)
        << "'" << refusal << "' does not say '" << damage.says << "'";
  }
}

}  // namespace
}  // namespace limpet::model
