// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/geometry/extend.hpp>
#include <limpet/geometry/polygon.hpp>

#include "perimeters.hpp"

namespace limpet::geometry {
namespace {

Verdict judged(const Cycles& cycles) {
  EdgeIds ids;
  const Verdict verdict = judge_cycles(cycles);
  EXPECT_EQ(Polygon::from_cycles(cycles, ids).has_value(), verdict == Verdict::valid);
  return verdict;
}

TEST(FromCycles, TakesOnlyValidPerimeters) {
  const auto square = rectangle(0, 0, 100, 100);
  const auto hole = [](double x0, double y0, double x1, double y1) {
    return reversed(rectangle(x0, y0, x1, y1));
  };
  EXPECT_EQ(judged({square}), Verdict::valid);
  EXPECT_EQ(judged({square, hole(10, 10, 20, 20), hole(21, 10, 30, 20)}), Verdict::valid);
  EXPECT_EQ(judged({}), Verdict::too_few_vertices);
  EXPECT_EQ(judged({cycle_of({{0, 0}, {5, 0}})}), Verdict::too_few_vertices);
  EXPECT_EQ(judged({cycle_of({{0, 0}, {5, 0}, {5, 0}, {0, 5}})}), Verdict::degenerate_edge);
  EXPECT_EQ(judged({cycle_of({{0, 0}, {9, 9}, {9, 0}, {0, 9}})}), Verdict::crossing);
  EXPECT_EQ(judged({cycle_of({{0, 0}, {9, 0}, {5, 0}, {5, 9}})}), Verdict::crossing);  // turns back
  EXPECT_EQ(judged({cycle_of({{0, 0}, {9, 0}, {4, 0}})}), Verdict::crossing);          // flat
  EXPECT_EQ(judged({reversed(square)}), Verdict::orientation);
  EXPECT_EQ(judged({square, rectangle(10, 10, 20, 20)}), Verdict::orientation);
  EXPECT_EQ(judged({square, hole(110, 10, 120, 20)}), Verdict::orientation);
  EXPECT_EQ(judged({square, hole(10, 10, 50, 50), hole(20, 20, 30, 30)}), Verdict::orientation);
  EXPECT_EQ(judged({square, hole(10, 10, 20, 20), hole(20, 20, 30, 30)}),
            Verdict::crossing);  // corners touch
  EXPECT_EQ(judged({square, hole(0, 10, 20, 20)}), Verdict::crossing);
  EXPECT_EQ(judged({square, hole(90, 10, 120, 20)}), Verdict::crossing);
  // A vertex that touches an edge of its own cycle.
  EXPECT_EQ(judged({cycle_of({{0, 0}, {10, 0}, {10, 10}, {5, 0}, {0, 10}})}), Verdict::crossing);
}

TEST(FromCycles, KeepsIdentitiesItIsGiven) {
  EdgeIds ids(100);
  auto square = rectangle(0, 0, 10, 10);
  square[1].edge = {7}, square[1].shared = true;
  const Polygon p = make({square}, ids);
  const auto vertices = p.vertices(p.cycles()[0]);
  EXPECT_EQ(vertices[1].edge, EdgeId{7});
  EXPECT_TRUE(vertices[1].shared);
  EXPECT_EQ(vertices[0].edge, EdgeId{100});
  EXPECT_EQ(ids.next(), 103u);
}

TEST(Locate, TellsTheThreeSidesApart) {
  EdgeIds ids;
  const Polygon ring = make({rectangle(0, 0, 30, 30), reversed(rectangle(10, 10, 20, 20))}, ids);
  EXPECT_EQ(ring.locate({5, 5}), Polygon::Side::inside);
  EXPECT_EQ(ring.locate({15, 15}), Polygon::Side::outside);
  EXPECT_EQ(ring.locate({31, 5}), Polygon::Side::outside);
  EXPECT_EQ(ring.locate({10, 15}), Polygon::Side::boundary);
  EXPECT_EQ(ring.locate({0, 0}), Polygon::Side::boundary);
}

TEST(Locate, AgreesWithAllEdges) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    EdgeIds ids;
    const double scale = random.chance(0.5) ? 1 : random.scale(1, 1e6);
    const Polygon p = random_polygon(random, ids, scale, random.scale(1, 4e9));
    expect_index_holds(p, random, 60);
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(Locate, AgreesWithAllEdgesOnTwoThousandEdges) {
  Random random(31);
  EdgeIds ids;
  const Polygon p = make(shapes::star(random, 2000, 1e6), ids);
  expect_index_holds(p, random, 300);
}

TEST(Index, HoldsAfterManyEdits) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    EdgeIds ids;
    Polygon p = random_polygon(random, ids, random.scale(1, 1000), random.scale(1, 4e9));
    const double gap = random.scale(3, 3000);
    for (int k = 0; k < 120; ++k) extend_to_point(p, telling_point(random, p, gap), gap, ids);
    expect_index_holds(p, random, 100);
    // As good as new: a copy built from the boundary says the same.
    const Polygon fresh = make(p.boundary(), ids);
    for (int k = 0; k < 100; ++k) {
      const Point2 q = telling_point(random, p, 3);
      ASSERT_EQ(p.locate(q), fresh.locate(q));
    }
  }
}

TEST(Counts, FollowTheBoundary) {
  EdgeIds ids;
  Polygon p = make({rectangle(0, 0, 30, 30), reversed(rectangle(10, 10, 20, 20))}, ids);
  EXPECT_EQ(p.edge_count(), 8u);
  EXPECT_EQ(p.hole_count(), 1u);
  Edit edit;
  edit.removed_cycles.push_back(CycleId{1});
  ASSERT_EQ(p.judge(edit), Verdict::valid);
  const auto version = p.version();
  p.commit(edit, ids);
  EXPECT_GT(p.version(), version);
  EXPECT_EQ(p.edge_count(), 4u);
  EXPECT_EQ(p.hole_count(), 0u);
  EXPECT_EQ(p.take_removed().size(), 4u);
  EXPECT_TRUE(p.take_removed().empty());
}

}  // namespace
}  // namespace limpet::geometry
