// Copyright the limpet authors. GPL-3.0-or-later.
//
// A timeline says of each step what the model was then: it is written while models grow, read by the other
// half of the format, and compared with the models.
#include <gtest/gtest.h>

#include <cmath>
#include <limpet/drawing/timeline.hpp>
#include <limpet/io/lifted.hpp>
#include <limpet/model/model.hpp>
#include <limpet/model/view.hpp>

#include "../model/streams.hpp"
#include "timeline_reader.hpp"

namespace limpet::drawing::testing {
namespace {

using namespace model::testing;
using model::Model;
using model::SegmentId;

/// What a reader of the timeline must hold now, by the model's record.
void expect_same(const TimelineReader& read, const Model& model, const TimelineSpace& space) {
  const model::ModelRecord record = model.record();
  ASSERT_EQ(read.points.size(), record.point_segments.size());
  for (const auto& segment : record.point_segments) {
    const auto found = read.points.find(segment.id);
    ASSERT_NE(found, read.points.end());
    EXPECT_EQ(found->second.count, segment.moments.count);
    EXPECT_EQ(found->second.at, space.at(model.view().segment({segment.id})->plane.point));
  }
  ASSERT_EQ(read.polygons.size(), record.polygon_segments.size());
  for (const io::LiftedPolygon& polygon : io::lift(record)) {
    const auto found = read.polygons.find(polygon.id);
    ASSERT_NE(found, read.polygons.end());
    EXPECT_EQ(found->second.count, polygon.points);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(static_cast<double>(found->second.plane[k]) / 0x1p24, polygon.normal[static_cast<int>(k)],
                  1e-6);
    ASSERT_EQ(found->second.boundary.cycles.size(), polygon.cycles.size());
    for (std::size_t c = 0; c < polygon.cycles.size(); ++c) {
      const auto& cycle = found->second.boundary.cycles[c];
      EXPECT_EQ(cycle.hole, c > 0);
      ASSERT_EQ(cycle.vertices.size(), polygon.cycles[c].size());
      // The record may begin a cycle at another of its vertices.
      std::map<std::uint64_t, const io::LiftedVertex*> by_edge;
      for (const auto& vertex : polygon.cycles[c]) by_edge[vertex.edge] = &vertex;
      for (const auto& vertex : cycle.vertices) {
        ASSERT_TRUE(by_edge.contains(vertex.edge));
        EXPECT_EQ(vertex.partner, by_edge[vertex.edge]->partner);
        EXPECT_LT((space.world(vertex.at) - by_edge[vertex.edge]->at).norm(), space.step);
      }
    }
  }
}

double area_of(const Model& model) {
  double area = 0;
  for (const io::LiftedPolygon& polygon : io::lift(model.record())) area += io::area(polygon);
  return area;
}

/// Writes a stream's timeline, and reads it beside a model that grows in the same way.
void expect_told(const Scan& scan, std::size_t every) {
  const TimelineSpace space{scan.points.front().position, timeline_step(scan.parameters.resolution)};
  constexpr std::size_t kSet = 26;
  Timeline timeline(space);
  Model told(scan.parameters), model(scan.parameters);
  const auto set = [&](std::size_t i) {
    return std::span(scan.points).subspan(i, std::min(kSet, scan.points.size() - i));
  };
  for (std::size_t i = 0; i < scan.points.size(); i += kSet) {
    const auto& changes = told.update(set(i));
    const auto reasons = told.open_edges();
    timeline.add(told.view(), changes, {.reasons = i / kSet % 3 == 0 ? &reasons : nullptr});
  }
  const auto& changes = told.finish();
  const auto reasons = told.open_edges();
  timeline.add(told.view(), changes, {.reasons = &reasons});

  TimelineReader read(timeline.stream(), false);
  std::size_t steps = 0;
  for (std::size_t i = 0; i < scan.points.size(); i += kSet) {
    model.update(set(i));
    read.step();
    if (++steps % every != 0) continue;
    SCOPED_TRACE("step " + std::to_string(steps));
    ASSERT_NO_FATAL_FAILURE(expect_same(read, model, space));
  }
  model.finish();
  read.step();
  expect_same(read, model, space);
  EXPECT_TRUE(read.at_end());
  EXPECT_EQ(timeline.steps(), steps + 1);
  EXPECT_NEAR(timeline.area().back(), area_of(model), 1e-4 * area_of(model));
  ASSERT_EQ(read.reasons.size(), reasons.size());
  for (const model::OpenEdge& e : reasons)
    EXPECT_EQ(read.reasons[e.edge.value], std::pair(static_cast<std::uint64_t>(e.refusal), e.other.value));
}

TEST(Timeline, TellsEachStepOfModelsThatGrow) {
  const std::uint64_t seed = wanted("LIMPET_SEED", 20261130);
  SCOPED_TRACE("seed " + std::to_string(seed));
  using Order = simulation::ScanOptions::Order;
  expect_told(scanned("step_hole", 6'000, 0.001, Order::shuffled, seed), 7);
  expect_told(scanned("city:3", 6'000, 0.001, Order::raster, seed), 11);
  expect_told(scanned("sphere", 3'000, 0, Order::shuffled, seed), 5);
}

TEST(Timeline, TellsInitialSegmentsAndWhatConfirmsThem) {
  Model model(of_resolution(0.0625));
  const std::vector<Vector3d> square = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  const TimelineSpace space{Vector3d::Zero(), timeline_step(0.0625)};
  Timeline timeline(space);
  const std::vector<model::InitialFace> faces = {{{square}}};
  const auto& added = model.add_initial(faces);
  timeline.add(model.view(), added, {});
  const Points readings = {{{0.1, 0.1, 0}, {0, 0, -1}}, {{0.2, 0.1, 0}, {0, 0, -1}}};
  const auto& confirmed = model.update(readings);
  timeline.add(model.view(), confirmed, {});
  TimelineReader read(timeline.stream(), false);
  read.step();
  ASSERT_EQ(read.polygons.size(), 1u);
  EXPECT_EQ(read.polygons.begin()->second.count, 0);
  read.step();
  EXPECT_EQ(read.polygons.begin()->second.count, 2);
  EXPECT_TRUE(read.polygons.begin()->second.initial);
  EXPECT_FLOAT_EQ(timeline.area().back(), 4);
  EXPECT_FLOAT_EQ(timeline.open_length().back(), 8);
}

TEST(Timeline, TellsWhatTheFollowerIsAfter) {
  Model model(of_resolution(1));
  const TimelineSpace space{{1, 2, 3}, 0.25};
  Timeline timeline(space);
  following::Intent intent;
  intent.targets = {{1, 2, 3}, {2, 2, 3}};
  intent.aim = {{2, 2, 3}, {2, 2, 4}};
  intent.way = {{0, 0, 0}};
  intent.edge = {std::uint64_t{1} << 40};
  intent.slice = {{{{Vector3d(1, 2, 3), Vector3d(1, 3, 3)}}, {{Vector3d(1, 2, 4), Vector3d(1, 3, 4)}}}};
  timeline.add(model.view(), {}, {.intent = &intent});
  const following::Intent nothing;
  timeline.add(model.view(), {}, {.intent = &nothing});
  TimelineReader read(timeline.stream(), true);
  read.step();
  EXPECT_EQ(read.intent.targets, (std::vector<Place>{{0, 0, 0}, {4, 0, 0}}));
  EXPECT_EQ(read.intent.aim, (std::vector<Place>{{4, 0, 0}, {4, 0, 4}}));
  EXPECT_EQ(read.intent.way, (std::vector<Place>{{-4, -8, -12}}));
  EXPECT_EQ(read.intent.edge, std::uint64_t{1} << 40);
  EXPECT_EQ(read.intent.segment, 0u);
  EXPECT_EQ(read.intent.slice, (std::vector<Place>{{0, 0, 0}, {0, 4, 0}, {0, 0, 4}, {0, 4, 4}}));
  read.step();
  EXPECT_TRUE(read.intent.targets.empty() && read.intent.aim.empty() && read.intent.slice.empty());
  EXPECT_TRUE(read.at_end());
}

/// Edges that come and go at random, cycles that turn, partners and places that change.
TEST(Boundary, IsReadBackAfterAnyChange) {
  const std::uint64_t seed = wanted("LIMPET_SEED", 7);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  std::uint64_t next = 1;
  const auto vertex = [&] {
    const auto far = [&] { return static_cast<std::int64_t>(random.below(1u << 30)) - (1 << 29); };
    return BoundaryVertex{next++, random.below(2) ? random.below(1u << 20) + 1 : 0, {far(), far(), far()}};
  };
  Boundary boundary;
  for (int round = 0; round < 300; ++round) {
    const Boundary before = boundary;
    if (boundary.cycles.empty() || random.below(10) == 0)
      boundary.cycles.push_back({!boundary.cycles.empty(), {vertex(), vertex(), vertex()}});
    if (boundary.cycles.size() > 3) boundary.cycles.erase(boundary.cycles.begin() + 1);
    for (Boundary::Cycle& cycle : boundary.cycles) {
      auto& v = cycle.vertices;
      const auto place = [&] { return v.begin() + static_cast<std::ptrdiff_t>(random.below(v.size())); };
      if (random.below(2)) v.insert(place(), vertex());
      if (random.below(3) == 0 && v.size() > 3) v.erase(place());
      if (random.below(3) == 0) std::rotate(v.begin(), place(), v.end());
      if (random.below(3) == 0) place()->at[0] += 5;
      if (random.below(3) == 0) place()->partner = 0;
      if (random.below(4) == 0) std::swap(*place(), *place());
    }
    // One polygon, as in a timeline: nothing gone, no points, one polygon with a new boundary, no reasons.
    VarintWriter one, other;
    for (VarintWriter* out : {&one, &other}) {
      for (const int n : {0, 0, 1, 9, 4}) out->put(static_cast<std::uint64_t>(n));
      put_boundary(out == &one ? before : boundary, out == &one ? Boundary{} : before, *out);
      out->put(0);
    }
    TimelineReader read(one.bytes() + other.bytes(), false);
    read.step();
    EXPECT_EQ(read.polygons[9].boundary, before);
    read.step();
    EXPECT_EQ(read.polygons[9].boundary, boundary) << "round " << round;
    EXPECT_TRUE(read.at_end());
  }
}

/// What is as it was is told in a few bytes.
TEST(Boundary, OneNewVertexAmongThousandsIsAFewBytes) {
  Boundary boundary;
  boundary.cycles.push_back({});
  for (std::uint64_t i = 1; i <= 5000; ++i)
    boundary.cycles[0].vertices.push_back({i, 0, {static_cast<std::int64_t>(i * 1000), 0, 0}});
  Boundary now = boundary;
  now.cycles[0].vertices.insert(now.cycles[0].vertices.begin() + 2500, {6000, 0, {2500, 400, 0}});
  VarintWriter out;
  put_boundary(now, boundary, out);
  EXPECT_LT(out.bytes().size(), 30u);
}

}  // namespace
}  // namespace limpet::drawing::testing
