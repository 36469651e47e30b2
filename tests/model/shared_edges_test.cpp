// Copyright the limpet authors. GPL-3.0-or-later.
//
// Known shapes become what they are: closed, every edge shared by the right two polygons, corners where the
// truth has them (thesis §2.6 to §2.8).
#include <gtest/gtest.h>

#include <limpet/io/welded.hpp>

#include "judged_scan.hpp"

namespace limpet::model {
namespace {

using namespace testing;

/// How many scans of each shape are taken: LIMPET_SEEDS, else 1.
const std::uint64_t kSharingSeeds = wanted("LIMPET_SEEDS", 1);

struct KnownShape {
  std::string name;
  std::int64_t points;
  int sides, corners;  ///< between two faces; where three faces or more meet
  bool closed = true;
};

const std::vector<KnownShape>& known_shapes() {
  static const std::vector<KnownShape> all{{"cube", 6'000, 12, 8},           {"L", 6'000, 18, 12},
                                           {"pyramid", 6'000, 8, 5},         {"octahedron", 6'000, 12, 6},
                                           {"open_box", 6'000, 8, 4, false}, {"step_hole", 31'000, 30, 20},
                                           {"plate3", 26'000, 48, 32}};
  return all;
}

/// Vertices that join two edges shared with different neighbours, each counted once however many have it.
std::int64_t corners_of(const ModelRecord& record) {
  return io::weld(io::lift(record), record.parameters.resolution).corners;
}

void expect_known(const KnownShape& shape, Order order, double noise, std::uint64_t seed) {
  const JudgedScan scan = judged_shape(shape.name, shape.points, noise, order, seed, 8);
  const Model model = watched(scan.parameters, scan.points, 20, 52);
  const ModelRecord record = model.record();
  const auto topology = scan.topology(record);
  EXPECT_TRUE(topology.isomorphic) << faults_of(topology);
  EXPECT_EQ(topology.closed, shape.closed);
  EXPECT_EQ(topology.true_shared, shape.sides);
  EXPECT_EQ(topology.shared, shape.sides);
  EXPECT_EQ(topology.false_shared, 0);
  EXPECT_LT(topology.vertex_distance, scan.parameters.resolution / 4);
  EXPECT_EQ(model.counts().shared_edges, shape.sides);
  EXPECT_EQ(corners_of(record), shape.corners);
  EXPECT_EQ(model.surfaces().size(), static_cast<std::size_t>(1 + model.counts().point_segments));
}

void expect_all_known(Order order, double noise) {
  for (std::uint64_t seed = 1; seed <= kSharingSeeds; ++seed)
    for (const KnownShape& shape : known_shapes()) {
      SCOPED_TRACE(shape.name + ", seed " + std::to_string(seed));
      expect_known(shape, order, noise, seed);
    }
}

TEST(KnownShapes, CloseInRasterOrder) { expect_all_known(Order::raster, 0); }
TEST(KnownShapes, CloseShuffled) { expect_all_known(Order::shuffled, 0); }
TEST(KnownShapes, CloseSampled) { expect_all_known(Order::sampled, 0); }
TEST(KnownShapes, CloseInRasterOrderWithNoise) { expect_all_known(Order::raster, 0.002); }
TEST(KnownShapes, CloseShuffledWithNoise) { expect_all_known(Order::shuffled, 0.002); }
TEST(KnownShapes, CloseSampledWithNoise) { expect_all_known(Order::sampled, 0.002); }

TEST(OpenBox, IsOpenAtItsRimAlone) {
  const JudgedScan scan = judged_shape("open_box", 6'000, 0, Order::sampled);
  const ModelRecord record = watched(scan.parameters, scan.points).record();
  for (const auto& s : record.polygon_segments) {
    const auto cycle = world_perimeter(s, record.grid_step);
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      if (s.cycles[0][i].partner != 0) continue;
      EXPECT_NEAR(cycle[i].z(), 1, 2 * scan.parameters.resolution);
      EXPECT_NEAR(cycle[(i + 1) % cycle.size()].z(), 1, 2 * scan.parameters.resolution);
    }
  }
}

/// Wherever a stream stops, the model is sound and its neighbours are true ones.
TEST(KnownShapes, HaveTrueNeighboursAtAnyTime) {
  for (const std::string name : {"cube", "L", "octahedron"}) {
    const JudgedScan scan = judged_shape(name, 12'000, 0.001, Order::shuffled, 3);
    Model model(scan.parameters);
    const std::size_t part = scan.points.size() / 8;
    for (std::size_t i = 0; i < 8; ++i) {
      feed(model, Points(scan.points.begin() + static_cast<std::ptrdiff_t>(i * part),
                         scan.points.begin() + static_cast<std::ptrdiff_t>((i + 1) * part)));
      EXPECT_EQ(broken_laws(model.record()), "") << name << " part " << i;
      const int false_shared = scan.topology(model.record()).false_shared;
      EXPECT_TRUE(i < 4 || false_shared == 0) << name << " part " << i << " " << false_shared;
    }
  }
}

TEST(Neighbours, AreNoneUnlessWanted) {
  JudgedScan scan = judged_shape("cube", 10'000, 0, Order::sampled);
  scan.parameters.neighbours = false;
  const Model model = watched(scan.parameters, scan.points);
  EXPECT_EQ(model.counts().polygons, 6);
  EXPECT_EQ(model.counts().shared_edges, 0);
  EXPECT_EQ(model.surfaces().size(), static_cast<std::size_t>(6 + model.counts().point_segments));
}

}  // namespace
}  // namespace limpet::model
