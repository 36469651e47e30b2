// Copyright the limpet authors. GPL-3.0-or-later.
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include <limpet/model/spatial_index_internal.hpp>

#include "../not_finite.hpp"
#include "streams.hpp"

namespace limpet::model {
namespace {

using namespace testing;
using Order = simulation::ScanOptions::Order;

TEST(Model, OnePlaneIsOnePolygon) {
  Random random(1);
  const Model model = modelled(of_resolution(0.1), plate(random, 2000, 0, 0, 1, 1));
  const ModelRecord record = model.record();
  ASSERT_EQ(record.polygon_segments.size(), 1u);
  EXPECT_TRUE(record.point_segments.empty());
  const auto& plane = record.polygon_segments[0];
  EXPECT_EQ(plane.moments.count, 2000);
  EXPECT_LT((normal_of(plane) - Vector3d::UnitZ()).norm(), 1e-9);
  ASSERT_EQ(plane.cycles.size(), 1u);
  Box3 box;
  for (const auto& v : world_perimeter(plane, record.grid_step)) {
    box.extend(v);
    EXPECT_NEAR(v.z(), 0, 1e-9);
  }
  EXPECT_LT((box.min() - Vector3d(0, 0, 0)).norm(), 0.1);
  EXPECT_LT((box.max() - Vector3d(1, 1, 0)).norm(), 0.1);
  EXPECT_EQ(broken_laws(record), "");
}

/// The few points of a fragment know its plane badly, so badly that far away it is off by more than λ. It
/// belongs to the large polygon beside it all the same.
TEST(Model, AFragmentJoinsAPolygonManyTimesItsSize) {
  constexpr double kNoise = 1. / 64;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    Parameters parameters = of_resolution(1);
    parameters.noise = kNoise;
    Model model(parameters);
    feed(model, plate(random, 15, 0, 0, 1, 1, kNoise));
    feed(model, plate(random, 20000, 2.5, 0, 600, 3, kNoise));
    feed(model, plate(random, 20, 1, 0, 2.6, 1, kNoise));
    model.finish();
    EXPECT_EQ(model.record().polygon_segments.size(), 1u) << "seed " << seed;
    EXPECT_EQ(broken_laws(model.record()), "") << "seed " << seed;
  }
}

/// Two slopes that meet in a ridge along y, each `width` wide and 20 long, inclined by so much; from the
/// eaves up.
Points shallow_roof(Random& random, double slope_rad, double width, std::size_t count) {
  Points points;
  while (points.size() < count) {
    const double x = width * (2 * random.uniform() - 1), y = 20 * random.uniform();
    points.push_back({{x, y, -std::tan(slope_rad) * std::abs(x)}, -Vector3d::UnitZ()});
  }
  std::stable_sort(points.begin(), points.end(), [](const SensorPoint& a, const SensorPoint& b) {
    return a.position.z() < b.position.z();
  });
  return points;
}

TEST(Model, PlanesThatDifferByMoreThanTheAngularResolutionStayTwo) {
  // The thesis's rules: all of the roof is within λ of one plane.
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    Parameters parameters = of_resolution(1);
    parameters.rules = Rules::thesis();
    const double slope_rad = 0.8 * parameters.angle_rad;
    const ModelRecord record = modelled(parameters, shallow_roof(random, slope_rad, 4, 4000)).record();
    ASSERT_EQ(record.polygon_segments.size(), 2u) << "seed " << seed;
    const double between = std::acos(
        std::min(1.0, normal_of(record.polygon_segments[0]).dot(normal_of(record.polygon_segments[1]))));
    EXPECT_GT(between, parameters.angle_rad) << "seed " << seed;
    EXPECT_EQ(broken_laws(record), "");
  }
}

/// Six polygons, one for each direction of the axes, each in its plane.
void expect_cube(const Scan& scan, double angle, double distance) {
  const Model model = modelled(scan.parameters, scan.points);
  const ModelRecord record = model.record();
  EXPECT_EQ(broken_laws(record), "");
  ASSERT_EQ(record.polygon_segments.size(), 6u);
  Eigen::Matrix<int, 3, 2> seen = Eigen::Matrix<int, 3, 2>::Zero();
  for (const auto& s : record.polygon_segments) {
    EXPECT_EQ(s.cycles.size(), 1u);
    const Vector3d normal = normal_of(s);
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    ++seen(axis, normal[axis] > 0);
    EXPECT_LT(std::acos(std::min(1.0, std::abs(normal[axis]))), angle);
    Box3 box;
    for (const auto& v : world_perimeter(s, record.grid_step)) {
      box.extend(v);
      EXPECT_LT(std::min(std::abs(v[axis]), std::abs(v[axis] - 1)), distance);
    }
    EXPECT_NEAR(box.sizes()[(axis + 1) % 3], 1, 2 * scan.parameters.resolution);
    EXPECT_NEAR(box.sizes()[(axis + 2) % 3], 1, 2 * scan.parameters.resolution);
  }
  EXPECT_EQ(seen, (Eigen::Matrix<int, 3, 2>::Ones()));
}

TEST(Model, ACubeHasSixFaces) {
  for (const auto order : {Order::shuffled, Order::raster})
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
      expect_cube(scanned("cube", 10000, 0, order, seed), 1e-4, 1e-4);
}

TEST(Model, ANoisyCubeHasSixFaces) {
  for (const auto order : {Order::shuffled, Order::raster})
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
      expect_cube(scanned("cube", 10000, 0.002, order, seed), 0.25 * std::numbers::pi / 180, 0.004);
}

TEST(Model, IsEmptyBeforeAnythingIsSeen) {
  Model model(Parameters{});
  EXPECT_TRUE(model.update({}).empty());
  EXPECT_TRUE(model.finish().empty());
  const ModelRecord record = model.record();
  EXPECT_TRUE(record.point_segments.empty() && record.polygon_segments.empty());
  EXPECT_EQ(record.sets, 1);
  EXPECT_EQ(record.next_segment, 1u);
  EXPECT_EQ(broken_laws(record), "");
}

TEST(Model, WhatIsNoPointIsCountedAndLeftOut) {
  Model model(of_resolution(1));
  const double step = model.record().grid_step, edge = step * 0x1p48;
  const Vector3d down(0, 0, -1);
  const Points refused = {
      {{kNaN, 0, 0}, down},        {{0, kInfinity, 0}, down},    {{0, 0, -kInfinity}, down},
      {{0, 0, 0}, {0, 0, 0}},      {{0, 0, 0}, {kNaN, 0, 0}},    {{0, 0, 0}, {kInfinity, 0, 0}},
      {{edge + step, 0, 0}, down}, {{0, -edge - step, 0}, down}, {{0, 0, 1e300}, down}};
  const Points accepted = {{{edge, -edge, 0}, down}, {{1, 2, 3}, 1e-9 * down}, {{5, 5, 5}, 1e9 * down}};
  Points all = refused;
  all.insert(all.end(), accepted.begin(), accepted.end());
  model.keep_labels();
  model.update(all);
  const Counts counts = model.counts();
  EXPECT_EQ(counts.refused, static_cast<std::int64_t>(refused.size()));
  EXPECT_EQ(counts.points, static_cast<std::int64_t>(accepted.size()));
  EXPECT_EQ(counts.loose, counts.points);
  const auto labels = model.labels();
  ASSERT_EQ(labels.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(bool(labels[i]), i >= refused.size()) << i;
  const ModelRecord record = model.record();
  EXPECT_EQ(record.refused, counts.refused);
  EXPECT_EQ(broken_laws(record), "");
}

TEST(Model, CountsAreThoseOfTheRecord) {
  const Scan scan = scanned("plate3", 8000, 0, Order::shuffled);
  Model model(scan.parameters);
  feed(model, scan.points, 100);
  model.finish();
  const ModelRecord record = model.record();
  const Counts counts = model.counts();
  EXPECT_EQ(counts.points, static_cast<std::int64_t>(scan.points.size()));
  EXPECT_EQ(counts.sets, static_cast<std::int64_t>((scan.points.size() + 99) / 100));
  EXPECT_EQ(counts.polygons, static_cast<std::int64_t>(record.polygon_segments.size()));
  EXPECT_EQ(counts.point_segments, static_cast<std::int64_t>(record.point_segments.size()));
  EXPECT_EQ(counts.holes, static_cast<std::int64_t>(holes_of(record)));
  std::int64_t edges = 0, loose = 0;
  for (const auto& s : record.polygon_segments)
    for (const auto& cycle : s.cycles) edges += static_cast<std::int64_t>(cycle.size());
  for (const auto& s : record.point_segments) loose += s.moments.count;
  EXPECT_EQ(counts.edges, edges);
  EXPECT_EQ(counts.loose, loose);
  EXPECT_EQ(record.points, counts.points);
  EXPECT_EQ(record.sets, counts.sets);
}

TEST(Model, ParametersOutOfRangeAreRefused) {
  const auto refuses = [](double Parameters::*member, double bad) {
    Parameters p;
    p.*member = bad;
    EXPECT_THROW(Model{p}, std::invalid_argument) << bad;
  };
  for (const double bad : {0.0, -1.0, kNaN, kInfinity}) refuses(&Parameters::resolution, bad);
  for (const double bad : {0.0, -0.1, std::numbers::pi / 2, 3.0, kNaN, kInfinity})
    refuses(&Parameters::angle_rad, bad);
  for (const double bad : {-1e-9, kNaN, kInfinity}) {
    refuses(&Parameters::noise, bad);
    refuses(&Parameters::input_quantum, bad);
    refuses(&Parameters::tolerance, bad);
  }
  Parameters hasty;
  hasty.outlier_patience = -1;
  EXPECT_THROW(Model{hasty}, std::invalid_argument);
  Parameters negative;
  negative.redundancy_ratio = -0.1;
  EXPECT_THROW(Model{negative}, std::invalid_argument);
  Parameters steep;
  steep.angle_rad = 1.5;
  EXPECT_EQ(Model(steep).parameters().angle_rad, 1.5);
}

TEST(Model, SegmentsAreSurfacesOfTheirOwnUntilEdgesAreShared) {
  const Scan scan = scanned("cube", 5000, 0, Order::shuffled);
  const Model model = modelled(scan.parameters, scan.points);
  const ModelRecord record = model.record();
  std::vector<std::uint64_t> in_surfaces, in_record;
  for (const auto& surface : model.surfaces())
    for (const SegmentId id : surface) in_surfaces.push_back(id.value);
  for (const auto& s : record.point_segments) in_record.push_back(s.id);
  for (const auto& s : record.polygon_segments) in_record.push_back(s.id);
  std::sort(in_record.begin(), in_record.end());
  std::sort(in_surfaces.begin(), in_surfaces.end());
  EXPECT_EQ(in_surfaces, in_record);
}

TEST(Model, LabelsBeginWhenTheyAreAskedFor) {
  Random random(4);
  Model model(of_resolution(0.1));
  feed(model, plate(random, 300, 0, 0, 1, 1));
  model.keep_labels();
  feed(model, plate(random, 200, 0, 0, 1, 1));
  model.finish();
  const auto labels = model.labels();
  ASSERT_EQ(labels.size(), 200u);
  const ModelRecord record = model.record();
  ASSERT_EQ(record.polygon_segments.size(), 1u);
  for (const SegmentId id : labels) EXPECT_EQ(id.value, record.polygon_segments[0].id);
}

TEST(Record, IsReadBackAsTheSameModel) {
  for (const char* shape : {"cube", "plate3"}) {
    const Scan scan = scanned(shape, 6000, 0.001, Order::shuffled);
    Model model(scan.parameters);
    feed(model, scan.points);
    for (int finished = 0; finished < 2; ++finished) {
      const ModelRecord record = model.record();
      EXPECT_EQ(bytes(Model(record).record()), bytes(record)) << shape;
      model.finish();
    }
  }
}

TEST(Record, WithAPerimeterThatIsNotValidIsRefused) {
  const Scan scan = scanned("cube", 3000, 0, Order::shuffled);
  const ModelRecord record = modelled(scan.parameters, scan.points).record();
  ASSERT_FALSE(record.polygon_segments.empty());
  ModelRecord reversed = record;
  auto& cycle = reversed.polygon_segments[0].cycles[0];
  std::reverse(cycle.begin(), cycle.end());
  EXPECT_THROW(Model{reversed}, std::invalid_argument);
  ModelRecord crossing = record;
  // One vertex goes to the far side and beyond.
  auto& vertices = crossing.polygon_segments[0].cycles[0];
  const VertexRecord across = vertices[vertices.size() / 2];
  vertices[0].x = 3 * across.x - 2 * vertices[0].x;
  vertices[0].y = 3 * across.y - 2 * vertices[0].y;
  EXPECT_THROW(Model{crossing}, std::invalid_argument);
  ModelRecord parameters = record;
  parameters.parameters.resolution = -1;
  EXPECT_THROW(Model{parameters}, std::invalid_argument);
}

TEST(Record, GoneOnFromGivesAsGoodAModel) {
  const Scan scan = scanned("cube", 10000, 0.002, Order::shuffled);
  Model model(scan.parameters);
  const auto half = static_cast<std::ptrdiff_t>(scan.points.size() / 2);
  feed(model, {scan.points.begin(), scan.points.begin() + half});
  Model again(model.record());
  feed(again, {scan.points.begin() + half, scan.points.end()});
  again.finish();
  const ModelRecord record = again.record();
  EXPECT_EQ(record.polygon_segments.size(), 6u);
  EXPECT_EQ(record.points, static_cast<std::int64_t>(scan.points.size()));
  EXPECT_EQ(points_in_segments(record) + record.expired, record.points);
  EXPECT_EQ(broken_laws(record), "");
}

}  // namespace
}  // namespace limpet::model
