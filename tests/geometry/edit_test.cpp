// Copyright the limpet authors. GPL-3.0-or-later.
//
// judge(Edit) looks only at what changes; here it is held against judge_polygon of the whole result.
#include <array>

#include <limpet/geometry/measure.hpp>

#include "perimeters.hpp"

namespace limpet::geometry {
namespace {

Slot any_slot(Random& random, const Polygon& p) {
  for (;;) {
    const Slot s{static_cast<std::uint32_t>(random.bits() % p.slot_count())};
    if (p.alive(s)) return s;
  }
}

Slot ahead(const Polygon& p, Slot s, std::int64_t steps) {
  while (steps-- > 0) s = p.next(s);
  return s;
}

std::vector<NewVertex> any_points(Random& random, const Polygon& p, std::int64_t most) {
  std::vector<NewVertex> via;
  for (std::int64_t k = random.whole(0, most); k > 0; --k) via.push_back({telling_point(random, p, 6)});
  return via;
}

/// One chain, two on one cycle, a removed cycle, a new loop: anything whose parts do not overlap.
Edit any_edit(Random& random, const Polygon& p) {
  Edit edit;
  const Slot from = any_slot(random, p);
  const auto size = static_cast<std::int64_t>(p.cycle(p.node(from).cycle).size);
  switch (random.whole(0, 6)) {
    case 0: {  // two chains on one cycle, joined straight or crosswise
      const std::int64_t i = random.whole(1, size), j = random.whole(i, size), k = random.whole(j, size);
      if (j == size || k == j) break;
      const Slot b = ahead(p, from, i), c = ahead(p, from, j), d = ahead(p, from, k);
      const bool crosswise = random.chance(0.5);
      edit.chains.push_back({from, any_points(random, p, 2), crosswise ? d : b});
      edit.chains.push_back({c, any_points(random, p, 2), crosswise ? b : d});
      return edit;
    }
    case 1:
      edit.removed_cycles.push_back(p.node(from).cycle);
      if (random.chance(0.3)) edit.loops.push_back(any_points(random, p, 5));
      return edit;
    case 2: {  // a new loop, often a small one beside a perimeter point
      const Point2 q = telling_point(random, p, 6);
      auto loop = random.chance(0.5) ? any_points(random, p, 5) : rectangle(q.x, q.y, q.x + 1, q.y + 1);
      edit.loops.push_back(random.chance(0.5) ? reversed(loop) : loop);
      return edit;
    }
    case 3: {  // chains on two cycles, straight or joined
      const Slot other = any_slot(random, p);
      if (p.node(other).cycle == p.node(from).cycle) break;
      const Slot a = ahead(p, from, random.whole(1, 2)), b = ahead(p, other, random.whole(1, 2));
      const bool joined = random.chance(0.7);
      edit.chains.push_back({from, any_points(random, p, 1), joined ? b : a});
      edit.chains.push_back({other, any_points(random, p, 1), joined ? a : b});
      return edit;
    }
    default:
      break;
  }
  edit.chains.push_back(
      {from, any_points(random, p, 2), ahead(p, from, random.whole(1, std::min<std::int64_t>(size, 5)))});
  return edit;
}

TEST(JudgeEdit, AcceptsExactlyWhatTheWholeJudgeAccepts) {
  std::array<int, 6> verdicts{};
  for (std::uint64_t seed = 1; seed <= 4000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    EdgeIds ids;
    Polygon p =
        random_polygon(random, ids, random.chance(0.7) ? 1 : random.scale(1, 1e6), random.scale(1, 1e9));
    for (int k = 0; k < 25; ++k) {
      const Edit edit = any_edit(random, p);
      const Polygon before = p;
      Polygon result = p;
      const Verdict verdict = p.judge(edit);
      ++verdicts[static_cast<std::size_t>(verdict)];
      ASSERT_TRUE(same_boundary(p, before));
      if (std::any_of(edit.loops.begin(), edit.loops.end(), [](const auto& l) { return l.empty(); }))
        continue;
      result.commit(edit, ids);  // even what was refused, to see what would have come of it
      ASSERT_EQ(verdict == Verdict::valid, judge_polygon(result) == Verdict::valid)
          << to_string(verdict) << " but " << to_string(judge_polygon(result));
      if (verdict == Verdict::valid) {
        const Point2 size = result.box().high - result.box().low;
        ASSERT_NEAR(result.area(), area(result), 1e-12 * size.x * size.y);
      }
      if (verdict != Verdict::valid) continue;
      expect_identities_hold(before, result);
      expect_index_holds(result, random, 5);
      if (HasFailure()) return;
      p = std::move(result);
    }
  }
  for (const int n : verdicts) EXPECT_GT(n, 20);  // every verdict was seen
}

TEST(JudgeEdit, RefusesPartsThatGetInEachOthersWay) {
  EdgeIds ids;
  const Polygon p = make({cycle_of({{0, 0}, {30, 0}, {60, 0}, {60, 60}, {30, 60}, {0, 60}})}, ids);
  const auto slot = [](std::uint32_t i) { return Slot{i}; };
  Edit same_start;
  same_start.chains = {{slot(0), {{{10, -5}}}, slot(2)}, {slot(0), {{{10, -9}}}, slot(3)}};
  EXPECT_NE(p.judge(same_start), Verdict::valid);
  Edit nested;
  nested.chains = {{slot(0), {{{10, -5}}}, slot(3)}, {slot(1), {{{40, -9}}}, slot(4)}};
  EXPECT_NE(p.judge(nested), Verdict::valid);
  Edit removed_too;
  removed_too.chains = {{slot(0), {{{10, -5}}}, slot(1)}};
  removed_too.removed_cycles = {CycleId{0}};
  EXPECT_NE(p.judge(removed_too), Verdict::valid);
}

TEST(JudgeEdit, RefusesToPassOverAHole) {
  EdgeIds ids;
  const Polygon ring = make({rectangle(0, 0, 90, 90), reversed(rectangle(40, 40, 50, 50))}, ids);
  Edit edit;
  edit.chains = {{Slot{0}, {{{45, 80}}}, Slot{1}}};
  EXPECT_EQ(ring.judge(edit), Verdict::swept_vertex);
  edit.chains = {{Slot{0}, {{{45, 20}}}, Slot{1}}};
  EXPECT_EQ(ring.judge(edit), Verdict::valid);
}

TEST(JudgeEdit, AsksOfANewLoopWhatSurroundsIt) {
  EdgeIds ids;
  const Polygon square = make({rectangle(0, 0, 90, 90)}, ids);
  Edit edit;
  edit.loops = {reversed(rectangle(30, 30, 60, 60))};
  EXPECT_EQ(square.judge(edit), Verdict::valid);
  edit.loops = {rectangle(30, 30, 60, 60)};
  EXPECT_EQ(square.judge(edit), Verdict::orientation);
  edit.loops = {reversed(rectangle(130, 30, 160, 60))};  // a hole outside
  EXPECT_EQ(square.judge(edit), Verdict::orientation);
  edit.loops = {reversed(rectangle(30, 30, 60, 60)), reversed(rectangle(40, 40, 50, 50))};
  EXPECT_EQ(square.judge(edit), Verdict::orientation);
}

TEST(Commit, BringsAlongIdentitiesAndSharing) {
  EdgeIds ids;
  Polygon p = make({rectangle(0, 0, 90, 90)}, ids);
  const EdgeId bottom = p.node(Slot{0}).edge, next = ids.take();
  Edit edit;
  edit.chains = {{Slot{0}, {{{45, -9}, next, true}}, Slot{1}, ids.take(), true}};
  ASSERT_EQ(p.judge(edit), Verdict::valid);
  p.commit(edit, ids);
  EXPECT_EQ(p.take_removed(), std::vector<EdgeId>{bottom});
  EXPECT_EQ(p.take_created().size(), 2u);
  EXPECT_EQ(p.node(p.next(Slot{0})).edge, next);
  EXPECT_TRUE(p.node(Slot{0}).shared);
  p.set_shared(Slot{0}, false);
  EXPECT_FALSE(p.node(Slot{0}).shared);
}

}  // namespace
}  // namespace limpet::geometry
