// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/geometry/fissure.hpp>
#include <limpet/geometry/unite.hpp>

#include "perimeters.hpp"

namespace limpet::geometry {
namespace {

constexpr double kUnitedGap = 40;

struct Union {
  bool done = false;
  Polygon before, result;
};
Union united(const Cycles& a, const Cycles& b, double gap = kUnitedGap) {
  EdgeIds ids;
  Union u;
  u.before = u.result = make(a, ids);
  const Polygon other = make(b, ids);
  u.done = unite(u.result, other, gap, ids);
  EXPECT_EQ(judge_polygon(u.result), Verdict::valid);
  if (!u.done) {
    EXPECT_TRUE(same_boundary(u.before, u.result));
  }
  expect_identities_hold(u.before, u.result);
  return u;
}

void expect_union(const Cycles& a, const Cycles& b, const Cycles& result, double gap = kUnitedGap) {
  for (const bool swapped : {false, true}) {
    const Union u = swapped ? united(b, a, gap) : united(a, b, gap);
    ASSERT_TRUE(u.done) << swapped;
    EXPECT_EQ(outline(u.result), outline(result)) << swapped;
  }
}

TEST(Unite, CrossingSquares) {
  expect_union(
      {rectangle(0, 0, 100, 100)}, {rectangle(50, 50, 150, 150)},
      {cycle_of({{0, 0}, {100, 0}, {100, 50}, {150, 50}, {150, 150}, {50, 150}, {50, 100}, {0, 100}})});
}

TEST(Unite, ACrossOfTwoBars) {
  expect_union({rectangle(0, 40, 100, 60)}, {rectangle(40, 0, 60, 100)},
               {cycle_of({{0, 40},
                          {40, 40},
                          {40, 0},
                          {60, 0},
                          {60, 40},
                          {100, 40},
                          {100, 60},
                          {60, 60},
                          {60, 100},
                          {40, 100},
                          {40, 60},
                          {0, 60}})});
}

TEST(Unite, CoincidentEdges) {
  const Cycles sum = {cycle_of({{0, 0}, {100, 0}, {200, 0}, {200, 100}, {100, 100}, {0, 100}})};
  const Union u = united({rectangle(0, 0, 100, 100)}, {rectangle(100, 0, 200, 100)});
  ASSERT_TRUE(u.done);
  EXPECT_EQ(outline(u.result), outline(sum));
}

TEST(Unite, PartOfAnEdgeCoincides) {
  expect_union(
      {rectangle(0, 0, 100, 100)}, {rectangle(100, 20, 200, 80)},
      {cycle_of({{0, 0}, {100, 0}, {100, 20}, {200, 20}, {200, 80}, {100, 80}, {100, 100}, {0, 100}})});
}

/// What touches in a point has no simple union: the second is moved a little, and overlaps then.
void expect_touching_united(const Cycles& a, const Cycles& b, double sum) {
  for (const bool swapped : {false, true}) {
    const Union u = swapped ? united(b, a, 4096) : united(a, b, 4096);
    ASSERT_TRUE(u.done) << swapped;
    EXPECT_EQ(u.result.hole_count(), 0u);
    EXPECT_NEAR(area(u.result), sum, 64 * perimeter(u.result));
  }
}

TEST(Unite, TouchingVertices) {
  expect_touching_united({rectangle(0, 0, 20000, 20000)}, {rectangle(20000, 20000, 40000, 40000)}, 8e8);
}

TEST(Unite, AVertexOnAnEdge) {
  expect_touching_united({rectangle(0, 0, 20000, 20000)},
                         {cycle_of({{20000, 10000}, {40000, 2000}, {40000, 18000}})}, 5.6e8);
}

TEST(Unite, AlmostCoincidentEdges) {
  expect_touching_united({cycle_of({{7432, 11148}, {16723, 13006}, {15793, 17651}, {6503, 15793}})},
                         {cycle_of({{16723, 13006}, {26014, 14864}, {25084, 19509}, {15794, 17651}})},
                         2 * 44884000.0);
}

TEST(Unite, OneInsideTheOther) {
  const Cycles large = {rectangle(0, 0, 100, 100)}, along = {rectangle(0, 20, 80, 80)};
  expect_union(large, {rectangle(20, 20, 80, 80)}, large);
  const Union u = united(large, along);
  ASSERT_TRUE(u.done);
  EXPECT_TRUE(same_boundary(u.before, u.result));
  // The other way round the edge of the inner one survives.
  EXPECT_EQ(outline(united(along, large).result),
            outline({cycle_of({{0, 0}, {100, 0}, {100, 100}, {0, 100}, {0, 80}, {0, 20}})}));
}

TEST(Unite, WithItself) {
  const Cycles ring = {rectangle(0, 0, 300, 300), reversed(rectangle(100, 100, 200, 200))};
  const Union u = united(ring, ring);
  ASSERT_TRUE(u.done);
  EXPECT_TRUE(same_boundary(u.before, u.result));
}

TEST(Unite, APlugClosesAFrame) {
  expect_union({rectangle(0, 0, 300, 300), reversed(rectangle(100, 100, 200, 200))},
               {rectangle(90, 90, 210, 210)}, {rectangle(0, 0, 300, 300)});
  expect_union({rectangle(0, 0, 300, 300), reversed(rectangle(100, 100, 200, 200))},
               {rectangle(100, 100, 200, 200)}, {rectangle(0, 0, 300, 300)});  // it fits exactly
}

TEST(Unite, APlugLeavesASlitThatCollapses) {
  const Cycles frame = {rectangle(0, 0, 300, 300), reversed(rectangle(100, 100, 200, 200))};
  EXPECT_EQ(outline(united({rectangle(90, 90, 180, 210)}, frame).result),
            outline({rectangle(0, 0, 300, 300)}));
  // A hole of the first that reaches beyond the second's box is left to fissures.
  EdgeIds ids;
  Polygon p = make(frame, ids);
  ASSERT_TRUE(unite(p, make({rectangle(90, 90, 180, 210)}, ids), kUnitedGap, ids));
  fill_fissures(p, p.take_created(), kUnitedGap, ids);
  EXPECT_EQ(outline(p), outline({rectangle(0, 0, 300, 300)}));
}

TEST(Unite, ACrossingBesideTheEndOfItsChainStays) {
  const Union u =
      united({cycle_of({{225045, 15003},
                        {240048, 15003},
                        {600120, 45009},
                        {570114, 45009},
                        {390078, 30006},
                        {405081, 30006}})},
             {cycle_of({{600119, -150030}, {795158, -150030}, {795158, 45009}, {600119, 45009}})}, 3);
  // The two overlap by a corner one step wide, which is made a few steps wide.
  const double both = 195039.0 * 195039 + 675270027;
  EXPECT_NEAR(area(u.result), both, 3 * perimeter(u.result));
}

TEST(Unite, AWebThinnerThanAStepIsMadeWiderWhereTheOtherCrossesIt) {
  // Two squares joined by a web 0.6 steps wide; the other ends in the middle of the web.
  const Union u = united({cycle_of({{0, 0},
                                    {3000, 0},
                                    {3000, 1499},
                                    {7000, 1501},
                                    {7000, 0},
                                    {10000, 0},
                                    {10000, 3000},
                                    {7000, 3000},
                                    {7000, 1502},
                                    {3000, 1500},
                                    {3000, 3000},
                                    {0, 3000}})},
                         {rectangle(-10, -10, 5000, 3010)}, 100);
  EXPECT_NEAR(area(u.result), 5010.0 * 3020 + 3000.0 * 3000 + 2000, 3 * 2000);
}

TEST(Unite, APlugLeavesAHole) {
  const Cycles frame = {rectangle(0, 0, 300, 300), reversed(rectangle(100, 100, 200, 200))};
  expect_union(frame, {rectangle(90, 90, 140, 210)},
               {rectangle(0, 0, 300, 300), reversed(rectangle(140, 100, 200, 200))});
}

TEST(Unite, TwoHooksEncloseAHole) {
  const Cycles hook = {
      cycle_of({{0, 0}, {300, 0}, {300, 100}, {100, 100}, {100, 200}, {300, 200}, {300, 300}, {0, 300}})};
  expect_union(
      hook, {rectangle(250, 10, 400, 290)},
      {cycle_of({{0, 0}, {300, 0}, {300, 10}, {400, 10}, {400, 290}, {300, 290}, {300, 300}, {0, 300}}),
       reversed(rectangle(100, 100, 250, 200))});
}

TEST(Unite, AnIslandAcrossTheEdgeOfItsHole) {
  const Cycles frame = {rectangle(0, 0, 300, 300), reversed(rectangle(100, 100, 200, 200))};
  expect_union(frame, {rectangle(150, 150, 210, 160)},
               {rectangle(0, 0, 300, 300), cycle_of({{100, 100},
                                                     {100, 200},
                                                     {200, 200},
                                                     {200, 160},
                                                     {150, 160},
                                                     {150, 150},
                                                     {200, 150},
                                                     {200, 100}})});
}

TEST(Unite, HolesOfOneUnderAndBesideTheOther) {
  const Cycles a = {rectangle(0, 0, 400, 300), reversed(rectangle(50, 50, 100, 250)),
                    reversed(rectangle(300, 50, 350, 250))};
  expect_union(
      a, {rectangle(200, -50, 500, 350)},
      {cycle_of({{0, 0}, {200, 0}, {200, -50}, {500, -50}, {500, 350}, {200, 350}, {200, 300}, {0, 300}}),
       reversed(rectangle(50, 50, 100, 250))});
}

TEST(Unite, DisjointPolygonsAreRefused) {
  EXPECT_FALSE(united({rectangle(0, 0, 100, 100)}, {rectangle(200, 0, 300, 100)}).done);
  EXPECT_FALSE(united({rectangle(0, 0, 100, 100)}, {cycle_of({{200, 0}, {203, 1}, {201, 4}})}).done);
}

TEST(Unite, EdgesKeepTheirIdentities) {
  EdgeIds ids;
  Polygon a = make({rectangle(0, 0, 100, 100)}, ids);
  auto square = rectangle(50, 50, 150, 150);
  square[1].shared = true;
  const Polygon b = make({square}, ids);
  ASSERT_TRUE(unite(a, b, kUnitedGap, ids));
  std::vector<std::uint64_t> kept;
  for (const auto boundary = a.boundary(); const NewVertex& v : boundary[0]) {
    if (v.edge.value <= 8) kept.push_back(v.edge.value);
    EXPECT_EQ(v.shared, v.edge.value == 6);
  }
  std::sort(kept.begin(), kept.end());
  EXPECT_EQ(kept, (std::vector<std::uint64_t>{1, 4, 6, 7}));
  EXPECT_EQ(a.take_removed(), (std::vector<EdgeId>{{2}, {3}}));
  EXPECT_EQ(a.take_created().size(), 6u);  // those that came from b too
}

TEST(Unite, EdgesOutsideTheWindowAreLeftAlone) {
  Random random(41);
  EdgeIds ids;
  Polygon a = make(shapes::star(random, 3000, 1e6), ids);
  const Polygon before = a;
  const Point2 v = a.at(a.cycles()[0].first);
  const Polygon b = make({rectangle(v.x - 500, v.y - 500, v.x + 500, v.y + 500)}, ids);
  ASSERT_TRUE(unite(a, b, kUnitedGap, ids));
  EXPECT_EQ(judge_polygon(a), Verdict::valid);
  expect_identities_hold(before, a);
  expect_index_holds(a, random, 100);
  EXPECT_GE(a.edge_count() + 8, before.edge_count());
}

}  // namespace
}  // namespace limpet::geometry
