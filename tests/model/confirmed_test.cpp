// Copyright the limpet authors. GPL-3.0-or-later.
//
// Readings on initial model segments (thesis §4.3) confirm them and make no segment.
#include <gtest/gtest.h>

#include <limpet/model/view.hpp>
#include <set>

#include "judged_scan.hpp"

namespace limpet::model {
namespace {

using namespace testing;

constexpr double kNoise = 0.001, kTolerance = 0.01, kLambda = 0.05;

/// A square of side 1 in the plane z = 0, its outside above; with a hole in the middle if asked.
InitialFace ground(bool hole = false) {
  InitialFace face{{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}};
  if (hole) face.cycles.push_back({{0.4, 0.4, 0}, {0.4, 0.6, 0}, {0.6, 0.6, 0}, {0.6, 0.4, 0}});
  return face;
}

Parameters expecting_noise() {
  Parameters p = of_resolution(kLambda);
  p.noise = kNoise;
  p.tolerance = kTolerance;
  return p;
}

Model knowing(const std::vector<InitialFace>& faces, const Parameters& parameters = expecting_noise()) {
  Model model(parameters);
  model.add_initial(faces);
  return model;
}

/// A single reading, and what the model made of it.
struct Told {
  std::int64_t confirmed = 0, segments = 0, changes = 0;
};
Told told(Model model, const SensorPoint& reading) {
  const auto changes = std::ssize(model.update({&reading, 1}));
  const Counts counts = model.counts();
  EXPECT_EQ(broken_laws(model.record()), "");
  EXPECT_EQ(counts.points, 1);
  return {counts.confirmed, counts.point_segments, changes};
}
void expect_confirms(Model model, const SensorPoint& reading) {
  const Told of = told(std::move(model), reading);
  EXPECT_EQ(of.confirmed, 1) << reading.position.transpose();
  EXPECT_EQ(of.segments, 0);
  EXPECT_EQ(of.changes, 0) << "nothing happens to any segment";
}
void expect_makes_a_segment(Model model, const SensorPoint& reading) {
  const Told of = told(std::move(model), reading);
  EXPECT_EQ(of.confirmed, 0) << reading.position.transpose();
  EXPECT_EQ(of.segments, 1);
}

const Vector3d kDown(0, 0, -1);

TEST(Confirmed, IsAnInitialSegmentByAReadingInItOrOnItsBorder) {
  for (const Vector3d& at : {Vector3d(0.2, 0.3, 0), Vector3d(0.2, 0.3, 0.9 * kTolerance),
                             Vector3d(0.2, 0.3, -0.9 * kTolerance), Vector3d(0.5, 0, 0), Vector3d(1, 1, 0)})
    expect_confirms(knowing({ground()}), {at, kDown});
  expect_confirms(knowing({ground()}), {{0.2, 0.3, 0}, {1, 0, -0.1}});
}

TEST(Confirmed, IsNoneByAReadingBeyondTheTolerance) {
  for (const double height : {1.1 * kTolerance, -1.1 * kTolerance, 0.4, -0.4})
    expect_makes_a_segment(knowing({ground()}), {{0.2, 0.3, height}, kDown});
}

TEST(Confirmed, ToleranceIsThreeStandardDeviationsOrWhatIsAskedForAndBelowTheResolution) {
  Parameters p = expecting_noise();
  p.tolerance = 0;
  expect_confirms(knowing({ground()}, p), {{0.2, 0.3, 2.9 * kNoise}, kDown});
  expect_makes_a_segment(knowing({ground()}, p), {{0.2, 0.3, 3.1 * kNoise}, kDown});
  p.noise = 0, p.noise_per_range = kNoise;  // at a range of 2, twice as much
  expect_confirms(knowing({ground()}, p), {{0.2, 0.3, 5.8 * kNoise}, kDown, 2});
  expect_makes_a_segment(knowing({ground()}, p), {{0.2, 0.3, 6.2 * kNoise}, kDown, 2});
  p.tolerance = 3 * kLambda;
  expect_confirms(knowing({ground()}, p), {{0.2, 0.3, 0.99 * kLambda}, kDown});
  expect_makes_a_segment(knowing({ground()}, p), {{0.2, 0.3, kLambda}, kDown});
}

TEST(Confirmed, IsNoneByAReadingOutsideItsPerimeter) {
  for (const Vector3d& at : {Vector3d(-0.001, 0.5, 0), Vector3d(0.5, 1.001, 0), Vector3d(2, 2, 0)})
    expect_makes_a_segment(knowing({ground()}), {at, kDown});
  expect_makes_a_segment(knowing({ground(true)}), {{0.5, 0.5, 0}, kDown});
  expect_confirms(knowing({ground(true)}), {{0.3, 0.5, 0}, kDown});
}

TEST(Confirmed, IsNoneFromBehindOrAlongIt) {
  for (const Vector3d& axis : {Vector3d(0, 0, 1), Vector3d(1, 0, 0), Vector3d(0.9, 0, 0.1)})
    expect_makes_a_segment(knowing({ground()}), {{0.2, 0.3, 0}, axis});
}

TEST(Confirmed, IsTheSideOfAThinWallThatIsSeen) {
  InitialFace below = ground();
  std::reverse(below.cycles[0].begin(), below.cycles[0].end());
  for (auto& v : below.cycles[0]) v.z() -= kTolerance / 2;
  Model model = knowing({ground(), below});
  model.keep_labels();
  const std::vector<SensorPoint> set{{{0.2, 0.3, -kTolerance / 3}, kDown}, {{0.2, 0.3, 0}, -kDown}};
  model.update(set);
  EXPECT_EQ(model.labels(), (std::vector<SegmentId>{{1}, {2}}));
  EXPECT_EQ(model.view().segment({1})->confirmed, 1);
  EXPECT_EQ(model.view().segment({2})->confirmed, 1);
  EXPECT_EQ(model.counts().confirmed, 2);
}

Points wall(Random& random, int count, double x0, double x1, double height, double noise) {
  Points points;
  for (const SensorPoint& p : plate(random, count, x0, 0, x1, height, noise))
    points.push_back({{p.position.x(), p.position.z(), p.position.y()}, Vector3d(0, -1, -0.5).normalized()});
  return points;
}

/// Everything but the identities: a stream in another order gives the same readings to the initial segments.
TEST(Confirmed, DoesNotDependOnTheOrderOfTheReadings) {
  Random random(7);
  Points points = plate(random, 2'000, -0.2, -0.2, 1.2, 1.2, kNoise);
  std::set<std::int64_t> counts;
  std::int64_t within = 0;
  for (const auto& p : points)
    within += std::abs(p.position.z()) < kTolerance && p.position.x() >= 0 && p.position.x() <= 1 &&
              p.position.y() >= 0 && p.position.y() <= 1;
  for (int order = 0; order < 4; ++order, shuffle(points, random)) {
    Model model = knowing({ground()});
    feed(model, points);
    counts.insert(model.counts().confirmed);
    EXPECT_EQ(broken_laws(model.record()), "");
  }
  EXPECT_EQ(counts, std::set<std::int64_t>{within});
}

TEST(Confirmed, PlaneIsNotGrownOverByAPolygonBesideIt) {
  Random random(3);
  Model model = knowing({ground()});
  const Points points = plate(random, 3'000, -0.5, 0, 1, 1, kNoise);
  feed(model, points);
  model.finish();
  const Counts counts = model.counts();
  EXPECT_EQ(counts.polygons, 2);
  EXPECT_LE(counts.loose, 2) << "at a corner, far from the others";
  EXPECT_EQ(counts.confirmed,
            std::count_if(points.begin(), points.end(), [](const auto& p) { return p.position.x() >= 0; }));
  for (const auto& s : model.record().polygon_segments) {
    if (s.moments.count == 0) continue;
    for (const auto& cycle : world_cycles(s, model.record().grid_step))
      for (const Vector3d& v : cycle) EXPECT_LT(v.x(), 1e-3);
  }
}

/// A wall that stands on the border, seen from above and before it: half of its lowest points lie, by their
/// noise, in the ground.
TEST(Confirmed, NeighboursAreBuiltUpToTheCommonEdge) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    Random random(seed);
    Points points = wall(random, 3'000, 0, 1, 1, kNoise);
    for (const auto& p : plate(random, 3'000, 0, 0, 1, 1, kNoise)) points.push_back(p);
    shuffle(points, random);
    Model model = knowing({ground()});
    feed(model, points);
    model.finish();
    EXPECT_EQ(broken_laws(model.record()), "");
    const Counts counts = model.counts();
    EXPECT_EQ(counts.polygons, 2);
    EXPECT_EQ(counts.shared_edges, 1);
    EXPECT_NEAR(static_cast<double>(counts.confirmed), 3'000, 30);
    EXPECT_LT(counts.loose + counts.expired, 30);
  }
}

/// A neighbour at any angle to the ground, half of whose points are seen from before the ground, too. The
/// sharper the edge, the wider the strip along it whose points may lie on the ground.
TEST(Confirmed, NeighboursAreBuiltAtSharpEdges) {
  for (const double side : {1.0, -1.0})  // above the ground, a concave edge; below, a convex one
    for (const double degrees : {20, 45, 90, 135}) {
      SCOPED_TRACE(side * degrees);
      const double c = std::cos(degrees * 0.017453292519943295), s = std::sqrt(1 - c * c);
      const Vector3d along(0, c, side * s), normal(0, side * s, -c);
      const Vector3d from_before = (-normal - 1.01 * Vector3d::UnitZ()).normalized();
      Random random(4);
      Points points;
      for (int i = 0; i < 3'000; ++i) {
        const Vector3d at = random.uniform(0, 1) * Vector3d::UnitX() + random.uniform(0, 1) * along;
        points.push_back({at + kNoise * random.normal() * normal,
                          i % 2 == 0 && from_before.dot(normal) < 0 ? from_before : Vector3d(-normal)});
      }
      Model model = knowing({ground()});
      feed(model, points);
      model.finish();
      EXPECT_EQ(broken_laws(model.record()), "");
      EXPECT_EQ(model.counts().polygons, 2);
      EXPECT_EQ(model.counts().shared_edges, 1);
      EXPECT_LT(model.counts().confirmed, 3'000 * kTolerance / s);
    }
}

TEST(Confirmed, ContradictedFacesStayAndWhatIsFeltIsModelledBesideThem) {
  Random random(5);
  Points points = plate(random, 3'000, 0, 0, 1, 1, kNoise);
  for (auto& p : points) p.position.z() += 2 * kTolerance;
  Model model = knowing({ground()}), alone(expecting_noise());
  feed(model, points), feed(alone, points);
  model.finish(), alone.finish();
  EXPECT_EQ(model.counts().confirmed, 0);
  EXPECT_EQ(model.counts().polygons, 1 + alone.counts().polygons);
  EXPECT_EQ(model.counts().loose, alone.counts().loose);
}

/// Points that came before the face was known confirm it when they are inserted again.
TEST(Confirmed, ByLoosePointsWhenTheModelIsFinished) {
  Model model(expecting_noise());
  const std::vector<SensorPoint> set{{{0.2, 0.3, 0}, kDown}, {{0.8, 0.3, 0}, kDown}};
  model.update(set);
  const InitialFace face = ground();
  model.add_initial({&face, 1});
  EXPECT_EQ(model.counts().loose, 2);
  model.finish();
  EXPECT_EQ(model.counts().loose, 0);
  EXPECT_EQ(model.counts().confirmed, 2);
  EXPECT_EQ(broken_laws(model.record()), "");
}

TEST(Confirmed, HoldsUnderTheThesisRules) {
  Parameters p = expecting_noise();
  p.rules = Rules::thesis();
  Random random(9);
  Model model = knowing({ground()}, p);
  feed(model, plate(random, 500, 0, 0, 1, 1));
  EXPECT_EQ(model.counts().confirmed, 500);
  EXPECT_EQ(model.counts().polygons, 1);
}

TEST(Confirmed, CountIsKeptByRecordsAndRefusedWhereThereCanBeNone) {
  Random random(2);
  Model model = knowing({ground()});
  Points points = plate(random, 500, 0, 0, 1, 1);
  for (const auto& p : plate(random, 2'000, 2, 2, 3, 3, kNoise)) points.push_back(p);
  feed(model, points);
  ModelRecord record = model.record();
  EXPECT_EQ(Model(record).counts().confirmed, 500);
  EXPECT_EQ(bytes(Model(record).record()), bytes(record));
  const auto felt = std::find_if(record.polygon_segments.begin(), record.polygon_segments.end(),
                                 [](const auto& s) { return s.moments.count > 0; });
  ASSERT_NE(felt, record.polygon_segments.end());
  felt->confirmed = 1;
  EXPECT_THROW(Model{record}, std::invalid_argument);
  felt->confirmed = 0;
  record.polygon_segments[0].confirmed = -1;
  EXPECT_THROW(Model{record}, std::invalid_argument);
}

/// A face that nothing comes near changes nothing but the identities that are given.
TEST(Confirmed, FacesOutOfReachChangeNothing) {
  const Scan scan = scanned("step_hole", 6'000, 0.002, simulation::ScanOptions::Order::raster, 3);
  InitialFace far = ground();
  for (auto& v : far.cycles[0]) v += Vector3d(100, 100, 100);
  Model alone(scan.parameters), beside(scan.parameters);
  beside.add_initial({&far, 1});
  feed(alone, scan.points), feed(beside, scan.points);
  alone.finish(), beside.finish();
  const auto cycles = [](const Model& model) {
    std::vector<std::vector<std::vector<Vector3d>>> all;
    for (const auto& s : model.record().polygon_segments)
      if (s.moments.count > 0) all.push_back(world_cycles(s, model.record().grid_step));
    return all;
  };
  EXPECT_EQ(cycles(alone), cycles(beside));
  EXPECT_EQ(beside.counts().confirmed, 0);
  EXPECT_EQ(alone.counts().loose, beside.counts().loose);
}

}  // namespace
}  // namespace limpet::model
