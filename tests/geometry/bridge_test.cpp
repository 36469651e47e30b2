// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/geometry/bridge.hpp>

#include "perimeters.hpp"

namespace limpet::geometry {
namespace {

constexpr double kBridgedGap = 4096;

TEST(Bridge, JoinsTwoSquaresHalfAGapApart) {
  EdgeIds ids;
  Polygon a = make({rectangle(0, 0, 10000, 10000)}, ids);
  const Polygon b = make({rectangle(12048, 0, 22048, 10000)}, ids);
  ASSERT_TRUE(bridge_polygons(a, b, kBridgedGap, ids));
  EXPECT_EQ(outline(a), outline({cycle_of({{0, 0},
                                           {10000, 0},
                                           {12048, 0},
                                           {22048, 0},
                                           {22048, 10000},
                                           {12048, 10000},
                                           {10000, 10000},
                                           {0, 10000}})}));
  EXPECT_EQ(a.take_removed(), std::vector<EdgeId>{EdgeId{2}});
  std::vector<std::uint64_t> of_b;
  for (const auto boundary = a.boundary(); const NewVertex& v : boundary[0])
    if (v.edge.value >= 5 && v.edge.value <= 8) of_b.push_back(v.edge.value);
  std::sort(of_b.begin(), of_b.end());
  EXPECT_EQ(of_b, (std::vector<std::uint64_t>{5, 6, 7}));
}

TEST(Bridge, ASmallSquareMeetsTheMiddleOfALongEdge) {
  const Cycles large = {rectangle(0, 0, 100000, 10000)}, small = {rectangle(50000, 11000, 51000, 12000)};
  for (const bool small_first : {false, true}) {
    EdgeIds ids;
    Polygon a = make(small_first ? small : large, ids);
    const Polygon before = a, b = make(small_first ? large : small, ids);
    ASSERT_TRUE(bridge_polygons(a, b, kBridgedGap, ids));
    EXPECT_EQ(judge_polygon(a), Verdict::valid);
    EXPECT_EQ(a.hole_count(), 0u);
    EXPECT_GE(area(a), area(before) + area(b) + 1000 * 1000);
    for (const double x : {50000.0, 50500.0, 51000.0})
      EXPECT_NE(a.locate({x, 10500}), Polygon::Side::outside);
    EXPECT_EQ(a.locate({50500, 10500}), Polygon::Side::inside);
    EXPECT_EQ(a.locate({50500, 12000}), Polygon::Side::boundary);
    expect_identities_hold(before, a);
  }
}

TEST(Bridge, AnIslandInAHole) {
  EdgeIds ids;
  Polygon ring = make({rectangle(0, 0, 60000, 60000), reversed(rectangle(10000, 10000, 50000, 50000))}, ids);
  const Polygon island = make({rectangle(12000, 12000, 30000, 30000)}, ids);
  const double before = area(ring) + area(island);
  ASSERT_TRUE(bridge_polygons(ring, island, kBridgedGap, ids));
  EXPECT_EQ(judge_polygon(ring), Verdict::valid);
  EXPECT_EQ(ring.hole_count(), 1u);
  EXPECT_GT(area(ring), before);
  EXPECT_EQ(ring.locate({20000, 20000}), Polygon::Side::inside);
}

TEST(Bridge, BringsTheOthersHolesAlong) {
  EdgeIds ids;
  Polygon a = make({rectangle(0, 0, 10000, 10000)}, ids);
  const Polygon b =
      make({rectangle(12048, 0, 22048, 10000), reversed(rectangle(13000, 1000, 21000, 9000))}, ids);
  ASSERT_TRUE(bridge_polygons(a, b, kBridgedGap, ids));
  EXPECT_EQ(a.hole_count(), 1u);
  EXPECT_EQ(judge_polygon(a), Verdict::valid);
}

TEST(Bridge, RefusesBeyondTheGapAndChangesNothing) {
  EdgeIds ids;
  Polygon a = make({rectangle(0, 0, 10000, 10000)}, ids);
  const Polygon before = a, b = make({rectangle(14097, 0, 22048, 10000)}, ids);
  EXPECT_FALSE(bridge_polygons(a, b, kBridgedGap, ids));
  EXPECT_TRUE(same_boundary(a, before));
}

/// An open ring whose mouth is `mouth` wide.
Cycles open_ring(double mouth) {
  const double y0 = 30000 - mouth / 2, y1 = 30000 + mouth / 2;
  return {cycle_of({{0, 0},
                    {60000, 0},
                    {60000, y0},
                    {50000, y0},
                    {50000, 10000},
                    {10000, 10000},
                    {10000, 50000},
                    {50000, 50000},
                    {50000, y1},
                    {60000, y1},
                    {60000, 60000},
                    {0, 60000}})};
}

TEST(BridgeSelf, ClosesARingAndLeavesItsHole) {
  EdgeIds ids;
  for (const std::uint32_t vertex : {2u, 3u, 8u, 9u}) {
    Polygon c = make(open_ring(2000), ids);
    ASSERT_TRUE(bridge_self(c, Slot{vertex}, kBridgedGap, ids)) << vertex;
    EXPECT_EQ(judge_polygon(c), Verdict::valid);
    EXPECT_EQ(c.hole_count(), 1u);
    EXPECT_EQ(c.locate({30000, 30000}), Polygon::Side::outside);
    EXPECT_EQ(c.locate({55000, 30000}), Polygon::Side::inside);
  }
}

TEST(BridgeSelf, LeavesAWideMouthOpen) {
  EdgeIds ids;
  Polygon c = make(open_ring(5000), ids);
  const Polygon before = c;
  for (std::uint32_t vertex = 0; vertex < 12; ++vertex)
    EXPECT_FALSE(bridge_self(c, Slot{vertex}, kBridgedGap, ids));
  EXPECT_TRUE(same_boundary(c, before));
}

TEST(BridgeSelf, KeepsSharedEdges) {
  EdgeIds ids;
  Cycles cycles = open_ring(2000);
  cycles[0][2].shared = cycles[0][8].shared = true;  // the mouth's two sides
  Polygon c = make(cycles, ids);
  for (std::uint32_t vertex = 0; vertex < 12; ++vertex) bridge_self(c, Slot{vertex}, kBridgedGap, ids);
  const auto removed = c.take_removed();
  for (const std::uint32_t s : {2u, 8u})
    EXPECT_EQ(std::count(removed.begin(), removed.end(), EdgeId{s + 1}), 0);
}

TEST(Bridge, ResultsAreValidAndLargerOnDegeneratePolygons) {
  int bridged = 0;
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    EdgeIds ids;
    Polygon a = random_polygon(random, ids, random.scale(1, 1000));
    const double gap = random.scale(2, 2000);
    Polygon b = random_polygon(random, ids, random.scale(1, 1000), perimeter(a) / 3 + gap);
    const bool disjoint = [&] {
      for (const auto& [p, q] : edges_of(a))
        for (const auto& [r, s] : edges_of(b))
          if (segments_meet(p, q, r, s)) return false;
      return a.locate(b.at(b.cycles()[0].first)) == Polygon::Side::outside &&
             b.locate(a.at(a.cycles()[0].first)) == Polygon::Side::outside;
    }();
    if (!disjoint) continue;
    const Polygon before = a;
    if (!bridge_polygons(a, b, gap, ids)) {
      ASSERT_TRUE(same_boundary(a, before));
      continue;
    }
    ++bridged;
    ASSERT_EQ(judge_polygon(a), Verdict::valid);
    ASSERT_GT(area(a), area(before) + area(b) - 2 * (perimeter(before) + perimeter(b)));
    expect_identities_hold(before, a);
    expect_index_holds(a, random, 10);
    if (HasFailure()) return;
  }
  EXPECT_GT(bridged, 100);
}

}  // namespace
}  // namespace limpet::geometry
