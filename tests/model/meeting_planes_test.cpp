// Copyright the limpet authors. GPL-3.0-or-later.
//
// Planes that meet in awkward ways: whatever is shared is sound after every set, and true where λ is small
// enough to tell.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "judged_scan.hpp"
#include "solids.hpp"

namespace limpet::model {
namespace {

using namespace testing;
using simulation::BoxWorld;

/// How many random polyhedra are scanned: LIMPET_SEEDS, else 3.
const std::uint64_t kMeetingSeeds = wanted("LIMPET_SEEDS", 3);

std::int64_t shared_edges(const Model& model) { return model.counts().shared_edges; }

/// The oracle looks after every set.
Model closely_watched(const JudgedScan& scan) { return watched(scan.parameters, scan.points, 1, 50); }

/// The sum of the areas of the polygons that face this way.
double area_facing(const ModelRecord& record, const Vector3d& way) {
  double area = 0;
  for (const auto& s : record.polygon_segments) {
    if (normal_of(s).dot(way) < 0.9) continue;
    for (const auto& cycle : world_cycles(s, record.grid_step))
      for (std::size_t i = 0; i < cycle.size(); ++i)
        area += way.dot(cycle[i].cross(cycle[(i + 1) % cycle.size()])) / 2;
  }
  return area;
}

// μ is 10°.
TEST(Folds, OfMoreThanTheAngularResolutionShareTheirEdge) {
  for (const double degrees : {11.0, -11.0, 15.0, -15.0, 45.0, -45.0, 90.0, -90.0, 150.0, -150.0})
    for (const std::uint64_t seed : {1, 2}) {
      SCOPED_TRACE(std::to_string(degrees) + " degrees, seed " + std::to_string(seed));
      const JudgedScan scan = sampled_scan(folded(degrees), 0.1, 0, seed);
      const Model model = closely_watched(scan);
      EXPECT_EQ(shared_edges(model), 1);
      const auto topology = scan.topology(model.record());
      EXPECT_TRUE(topology.isomorphic) << faults_of(topology);
    }
}

TEST(Folds, OfLessShareTheirEdgeAtTheEndOfInputAloneAndFromHalfOfItOn) {
  for (const double degrees : {9.0, -9.0, 7.0, -7.0, 4.5, -4.5, 3.0, -3.0})
    for (const std::uint64_t seed : {1, 2}) {
      SCOPED_TRACE(std::to_string(degrees) + " degrees, seed " + std::to_string(seed));
      JudgedScan scan = sampled_scan(folded(degrees), 0.1, 0, seed);
      EXPECT_EQ(shared_edges(closely_watched(scan)), std::abs(degrees) > 5 ? 1 : 0);
      Model before(scan.parameters);
      for (const auto& point : scan.points) before.update({&point, 1});
      EXPECT_EQ(shared_edges(before), 0);
      scan.parameters.rules = Rules::parse("-bends");
      EXPECT_EQ(shared_edges(closely_watched(scan)), 0);
    }
}

TEST(Folds, AtTheAngularResolutionAreSoundWhateverBecomesOfThem) {
  for (const double degrees : {9.9, 10.0, 10.1, -9.9, -10.0, -10.1, 179.0, -179.0}) {
    SCOPED_TRACE(std::to_string(degrees) + " degrees");
    for (const double noise : {0.0, 0.005}) {
      const JudgedScan scan = sampled_scan(folded(degrees), 0.1, noise);
      closely_watched(scan);
    }
  }
}

TEST(Planes, AHairApartShareNothing) {
  for (const double height : {0.03, 0.09, 0.2})
    for (const bool overlapping : {false, true})
      for (const bool turned : {false, true}) {
        SCOPED_TRACE(std::to_string(height) + (overlapping ? " overlapping" : "") +
                     (turned ? " turned" : ""));
        const double x = overlapping ? -0.5 : 0;
        MeshMaker maker;
        maker.face({{-1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {-1, 1, 0}});
        MeshMaker::Loop upper{{x, 0, height}, {1, 0, height}, {1, 1, height}, {x, 1, height}};
        if (turned) std::reverse(upper.begin(), upper.end());
        const JudgedScan scan = sampled_scan(maker.face(upper).make(), 0.1);
        EXPECT_EQ(shared_edges(closely_watched(scan)), 0);
      }
}

TEST(Planes, ThatStandOnAnotherDoNotCutIt) {
  for (const double depth : {0.0, 0.05, 1.0})  // how far the wall goes below the floor
    for (const double lean : {0.0, 0.7})
      for (const std::uint64_t seed : {1, 2}) {
        SCOPED_TRACE(std::to_string(depth) + " deep, leaning " + std::to_string(lean));
        const JudgedScan scan = sampled_scan(MeshMaker()
                                                 .face({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}})
                                                 .face({{-depth * lean, -0.5, -depth},
                                                        {-depth * lean, 0.5, -depth},
                                                        {lean, 0.5, 1},
                                                        {lean, -0.5, 1}})
                                                 .make(),
                                             0.1, 0, seed);
        const Model model = closely_watched(scan);
        EXPECT_NEAR(area_facing(model.record(), Vector3d::UnitZ()), 4, 0.4);
      }
}

/// A chance hole in the floor under the wall goes, and with it all the edges it shares, at the end.
TEST(Planes, LoseHolesWithTheirSharedEdges) {
  const JudgedScan scan = sampled_scan(MeshMaker()
                                           .face({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}})
                                           .face({{0, -1, -0.05}, {0, 1, -0.05}, {0, 1, 1}, {0, -1, 1}})
                                           .make(),
                                       0.1);
  const Model model = watched(scan.parameters, scan.points, 50);
  EXPECT_NEAR(area_facing(model.record(), Vector3d::UnitZ()), 16, 0.8);
}

TEST(Solids, ThinWedgesHaveNoFalseNeighbours) {
  for (const double degrees : {4.0, 8.0, 12.0}) {
    SCOPED_TRACE(std::to_string(degrees) + " degrees");
    const JudgedScan scan = sampled_scan(wedge(degrees), 0.05);
    const auto topology = scan.topology(closely_watched(scan).record());
    // At its thick end the thinnest is not 2 λ thick: what lies between its sides there may share edges.
    if (degrees > 5) {
      EXPECT_EQ(topology.false_shared, 0);
    }
  }
}

TEST(Solids, WedgesClose) {
  for (const double degrees : {20.0, 30.0, 60.0}) {
    SCOPED_TRACE(std::to_string(degrees) + " degrees");
    const JudgedScan scan = sampled_scan(wedge(degrees), 0.04);
    const auto topology = scan.topology(watched(scan.parameters, scan.points).record());
    EXPECT_TRUE(topology.closed);
    EXPECT_TRUE(topology.isomorphic) << faults_of(topology);
  }
}

TEST(Solids, ThatTouchAlongAnEdgeAreSound) {
  for (const double gap : {0.0, 0.05}) {
    SCOPED_TRACE(std::to_string(gap) + " apart");
    const JudgedScan scan = sampled_scan(
        MeshMaker().mesh(box({0, 0, 0}, {1, 1, 1})).mesh(box({1 + gap, 1, 0}, {2, 2, 1})).make(), 0.08);
    closely_watched(scan);
  }
}

TEST(Solids, WhoseApexTouchesAnEdgeAreSound) {
  const auto pyramid = MeshMaker()
                           .face({{0.5, 0, 1}, {0, -1, 1.5}, {1, -1, 1.5}})
                           .face({{0.5, 0, 1}, {1, -1, 1.5}, {1, -0.5, 2}})
                           .face({{0.5, 0, 1}, {1, -0.5, 2}, {0, -0.5, 2}})
                           .face({{0.5, 0, 1}, {0, -0.5, 2}, {0, -1, 1.5}})
                           .face({{0, -1, 1.5}, {0, -0.5, 2}, {1, -0.5, 2}, {1, -1, 1.5}})
                           .make();
  for (const std::uint64_t seed : {1, 2}) {
    const JudgedScan scan =
        sampled_scan(MeshMaker().mesh(box({0, 0, 0}, {1, 1, 1})).mesh(pyramid).make(), 0.08, 0, seed);
    closely_watched(scan);
  }
}

TEST(Tables, ShareTheirHoleWithTheBoxOnThem) {
  BoxWorld world;
  world.add({-1.5, -1.5, -1}, {1.5, 1.5, 0});
  world.add({-0.5, -0.5, 0}, {0.5, 0.5, 1});
  const Mesh truth = world.surface([](const Vector3d& middle, const Vector3d& normal) {
    return middle.z() > 0 || (middle.z() == 0 && normal.z() > 0);
  });
  for (const std::uint64_t seed : {1, 2, 3}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const JudgedScan scan = sampled_scan(truth, 0.1, 0.001, seed);
    const Model model = closely_watched(scan);
    const auto topology = scan.topology(model.record());
    EXPECT_TRUE(topology.isomorphic) << faults_of(topology);
    EXPECT_FALSE(topology.closed) << "the table's rim is open";
    EXPECT_EQ(topology.true_shared, 12);
    EXPECT_EQ(topology.false_shared, 0);
    EXPECT_EQ(holes_of(model.record()), 1u);
  }
}

TEST(Rooms, CloseFromInside) {
  BoxWorld world;
  world.add({-1, -1, -1}, {3, 2.5, 2});
  world.carve({0, 0, 0}, {2, 1.5, 1});
  const Mesh truth = world.surface([](const Vector3d& middle, const Vector3d&) {
    return (middle.array() > -0.5).all() && middle.x() < 2.5 && middle.y() < 2 && middle.z() < 1.5;
  });
  for (const std::uint64_t seed : {1, 2, 3}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const JudgedScan scan = sampled_scan(truth, 0.1, 0.002, seed);
    const Model model = closely_watched(scan);
    const auto topology = scan.topology(model.record());
    EXPECT_TRUE(topology.closed && topology.isomorphic) << faults_of(topology);
    EXPECT_EQ(shared_edges(model), 12);
  }
}

TEST(Surfaces, OfTwoCubesAreTwo) {
  const JudgedScan scan =
      sampled_scan(MeshMaker().mesh(box({0, 0, 0}, {1, 1, 1})).mesh(box({2, 0, 0}, {3, 1, 1})).make(), 0.08);
  const Model model = watched(scan.parameters, scan.points);
  ASSERT_EQ(model.counts().polygons, 12);
  std::vector<std::vector<SegmentId>> of_polygons;
  std::size_t segments = 0;
  for (const auto& surface : model.surfaces()) {
    EXPECT_TRUE(std::is_sorted(surface.begin(), surface.end()));
    segments += surface.size();
    if (surface.size() > 1) of_polygons.push_back(surface);
  }
  EXPECT_EQ(segments, static_cast<std::size_t>(12 + model.counts().point_segments));
  ASSERT_EQ(of_polygons.size(), 2u);
  EXPECT_EQ(of_polygons[0].size(), 6u);
  EXPECT_EQ(of_polygons[1].size(), 6u);
  EXPECT_LT(of_polygons[0].front(), of_polygons[1].front());
  // Each cube's polygons are one surface.
  for (const auto& surface : of_polygons) {
    std::set<bool> sides;
    for (const auto& s : model.record().polygon_segments)
      if (std::binary_search(surface.begin(), surface.end(), SegmentId{s.id}))
        sides.insert(world_perimeter(s, model.record().grid_step).front().x() < 1.5);
    EXPECT_EQ(sides.size(), 1u);
  }
}

TEST(RandomPolyhedra, HaveTrueNeighboursAlone) {
  std::uint64_t closed = 0;
  for (std::uint64_t seed = 1; seed <= kMeetingSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    constexpr double kResolution = 0.08;
    const Mesh truth = random_convex(random, 5 * kResolution);
    const double noise = random.below(2) ? random.uniform(0, kResolution / 10) : 0;
    const JudgedScan scan = sampled_scan(truth, kResolution, noise, seed);
    const ModelRecord record =
        watched(scan.parameters, scan.points, 1, static_cast<std::size_t>(100 + random.below(500))).record();
    const auto topology = scan.topology(record);
    EXPECT_EQ(topology.false_shared, 0) << faults_of(topology);
    closed += topology.closed && topology.isomorphic;
  }
  EXPECT_GE(2 * closed, kMeetingSeeds);
}

}  // namespace
}  // namespace limpet::model
