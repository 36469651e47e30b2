// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/geometry/merge.hpp>

#include <array>

#include "perimeters.hpp"

namespace limpet::geometry {
namespace {

constexpr double kMergedGap = 4096;

struct Merged {
  Merger outcome;
  Polygon before, result;
};
Merged merged(const Cycles& a, const Cycles& b) {
  EdgeIds ids;
  Merged m;
  m.before = m.result = make(a, ids);
  m.outcome = merge_polygons(m.result, make(b, ids), kMergedGap, ids);
  EXPECT_EQ(judge_polygon(m.result), Verdict::valid);
  const bool changed = m.outcome == Merger::united || m.outcome == Merger::bridged;
  EXPECT_NE(changed, same_boundary(m.before, m.result));
  return m;
}

TEST(Merge, TellsTheCasesApart) {
  const Cycles square = {rectangle(0, 0, 20000, 20000)};
  EXPECT_EQ(merged(square, {rectangle(100, 100, 9000, 9000)}).outcome, Merger::contained);
  EXPECT_EQ(merged(square, {rectangle(10000, 10000, 30000, 30000)}).outcome, Merger::united);
  EXPECT_EQ(merged(square, {rectangle(-10000, -10000, 30000, 30000)}).outcome, Merger::united);
  EXPECT_EQ(merged(square, {rectangle(22000, 0, 30000, 20000)}).outcome, Merger::bridged);
  EXPECT_EQ(merged(square, {rectangle(25000, 0, 30000, 20000)}).outcome, Merger::too_far);
  EXPECT_EQ(merged(square, {rectangle(22950, 22950, 30000, 30000)}).outcome, Merger::too_far);
}

/// After edits the outer perimeter need not be the first of the cycles, which may be free.
TEST(Merge, WhereverTheOuterPerimeterIsStored) {
  EdgeIds ids;
  Polygon a = make({rectangle(0, 0, 20000, 20000)}, ids);
  PolygonState state = make({rectangle(100, 100, 9000, 9000)}, ids).state();
  state.cycles.insert(state.cycles.begin(), Polygon::Cycle{});
  for (auto& node : state.nodes) node.cycle = CycleId{1};
  const Polygon b = Polygon::from_state(state);
  EXPECT_EQ(b.outer().size, 4u);
  EXPECT_EQ(merge_polygons(a, b, kMergedGap, ids), Merger::contained);
}

TEST(Merge, AnEnclosingPolygonReplacesTheOther) {
  const Merged m = merged({rectangle(0, 0, 20000, 20000)}, {rectangle(-10000, -10000, 30000, 30000)});
  EXPECT_EQ(outline(m.result), outline({rectangle(-10000, -10000, 30000, 30000)}));
}

TEST(Merge, AnIslandFarFromItsHolesEdgeIsTooFar) {
  const Cycles ring = {rectangle(0, 0, 90000, 90000), reversed(rectangle(10000, 10000, 80000, 80000))};
  EXPECT_EQ(merged(ring, {rectangle(40000, 40000, 50000, 50000)}).outcome, Merger::too_far);
  EXPECT_EQ(merged(ring, {rectangle(12000, 40000, 50000, 50000)}).outcome, Merger::bridged);
  EXPECT_EQ(merged(ring, {rectangle(9000, 40000, 50000, 50000)}).outcome, Merger::united);
}

TEST(Merge, ThePolygonWithTheHoleMayBeTheSecond) {
  const Cycles ring = {rectangle(0, 0, 90000, 90000), reversed(rectangle(10000, 10000, 80000, 80000))};
  const Merged m = merged({rectangle(12000, 40000, 50000, 50000)}, ring);
  EXPECT_EQ(m.outcome, Merger::bridged);
  EXPECT_EQ(m.result.hole_count(), 1u);
  EXPECT_GT(area(m.result), 90000.0 * 90000 - 70000.0 * 70000 + 38000.0 * 10000);
}

TEST(Merge, KeepsTheLawsOnDegeneratePolygons) {
  std::array<int, 5> outcomes{};
  for (std::uint64_t seed = 1; seed <= 1200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    EdgeIds ids;
    const double scale = random.chance(0.4) ? 1 : random.scale(1, 1e5);
    Polygon a = random_polygon(random, ids, scale);
    const double gap = std::max(2.0, std::floor(random.scale(0.5, 10) * scale));
    for (int k = 0; k < 4; ++k) {
      const Polygon before = a, b = random_polygon(random, ids, scale, perimeter(a) / 3);
      const Merger outcome = merge_polygons(a, b, gap, ids);
      ++outcomes[static_cast<std::size_t>(outcome)];
      ASSERT_EQ(judge_polygon(a), Verdict::valid);
      if (outcome != Merger::united && outcome != Merger::bridged) {
        ASSERT_TRUE(same_boundary(before, a));
      }
      ASSERT_GT(area(a), area(before) - 2 * perimeter(before) - 64 * perimeter(b));
      expect_identities_hold(before, a);
      expect_index_holds(a, random, 5);
      if (HasFailure()) return;
    }
  }
  for (const int n : outcomes) EXPECT_GT(n, 20);
}

}  // namespace
}  // namespace limpet::geometry
