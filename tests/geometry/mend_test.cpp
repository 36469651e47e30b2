// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/geometry/mend.hpp>

#include <limpet/geometry/judge.hpp>
#include <limpet/geometry/predicates.hpp>

#include "perimeters.hpp"

namespace limpet::geometry {
namespace {

using Cycles = std::vector<std::vector<NewVertex>>;

Cycles turned(const Cycles& cycles, double cosine, double sine) {
  Cycles result = cycles;
  for (auto& cycle : result)
    for (NewVertex& v : cycle)
      v.at = round_to_grid({cosine * v.at.x - sine * v.at.y, sine * v.at.x + cosine * v.at.y});
  return result;
}

/// A comb whose teeth leave gaps between them that are a few millionths of a tooth wide, at a slant.
Cycles slanted_comb(Random& random) {
  std::vector<NewVertex> cycle{{{0, -900}}, {{9000, -900}}};
  for (int tooth = 8; tooth >= 0; --tooth) {
    const double x = 1000.0 * tooth, lean = static_cast<double>(random.whole(-300, 300));
    cycle.push_back({{x + 990, 0}});
    cycle.push_back({{x + lean + 900, 5000}});
    cycle.push_back({{x + lean + 1, 4900}});
    if (tooth > 0) cycle.push_back({{x, static_cast<double>(random.whole(-3, 3))}});
  }
  return {cycle};
}

double largest_move(const Cycles& a, const Cycles& b) {
  double largest = 0;
  for (std::size_t c = 0; c < a.size(); ++c)
    for (std::size_t i = 0; i < a[c].size(); ++i) {
      const Point2 d = a[c][i].at - b[c][i].at;
      largest = std::max({largest, std::abs(d.x), std::abs(d.y)});
    }
  return largest;
}

/// A spike is driven into a square from below, its tip a hair (less than a step) from the opposite side.
Cycles spiked(Random& random) {
  const double x = static_cast<double>(random.whole(1000, 9000)),
               slope = static_cast<double>(random.whole(1, 97));
  const auto top = [&](double at) { return 10000 + slope * at / 10000; };
  return {{{{0, 0}},
           {{x - 50, 0}},
           {{x, std::ceil(top(x)) - 1}},
           {{x + 50, 0}},
           {{10000, 0}},
           {{10000, 10000 + slope}},
           {{0, 10000}}}};
}

TEST(RestoreSides, WhatRoundingBrokeIsValidAgainAndNearWhereItWas) {
  Random random(31);
  int broken = 0, restored = 0;
  for (int k = 0; k < 3000; ++k) {
    const Cycles before = spiked(random);
    if (judge_cycles(before) != Verdict::valid) continue;
    const double sine = 0.02 * random.unit(), cosine = std::sqrt(1 - sine * sine);
    const Cycles rounded = turned(before, cosine, sine);
    Cycles mended = rounded;
    const bool was_broken = judge_cycles(rounded) != Verdict::valid;
    broken += was_broken;
    const bool good = restore_sides(mended, before);
    if (!was_broken) {
      ASSERT_TRUE(good);
      ASSERT_EQ(largest_move(mended, rounded), 0) << "case " << k;
    }
    if (!good) continue;
    restored += was_broken;
    ASSERT_EQ(judge_cycles(mended), Verdict::valid) << "case " << k;
    ASSERT_LE(largest_move(mended, rounded), 8) << "case " << k;
  }
  EXPECT_GT(broken, 100);
  EXPECT_GE(restored, broken * 99 / 100);
}

TEST(MendCycles, LeavesNoConflictAndKeepsWhatIsValid) {
  Random random(32);
  for (int k = 0; k < 500; ++k) {
    Cycles cycles = slanted_comb(random);
    const bool valid = judge_cycles(cycles) == Verdict::valid;
    const Cycles before = cycles;
    if (!mend_cycles(cycles, 1e9)) continue;
    std::vector<KeyedEdge> edges;
    for (std::size_t i = 0, n = cycles.front().size(); i < n; ++i)
      edges.push_back({cycles.front()[i].at, cycles.front()[(i + 1) % n].at, i, (i + 1) % n});
    EXPECT_EQ(judge_edges(edges), Verdict::valid) << "case " << k;
    if (valid) {
      EXPECT_EQ(cycles.front().size(), before.front().size()) << "case " << k;
    }
  }
}

TEST(RestoreSides, NoVertexMovesFartherThanTwoStepsInSeveralConflicts) {
  const auto outer = cycle_of({{0, 0}, {0, 3}, {-3, 3}, {-3, 0}});
  const Cycles before = {outer, cycle_of({{-2, 1}, {-2, 2}, {-1, 2}, {-1, 1}})},
               moved = {outer, cycle_of({{-2, 1}, {-1, 2}, {-1, 2}, {0, 1}})};
  Cycles restored = moved;
  restore_sides(restored, before);
  for (std::size_t c = 0; c < moved.size(); ++c)
    for (std::size_t i = 0; i < 4; ++i) {
      const Point2 d = restored[c][i].at - moved[c][i].at;
      EXPECT_LE(std::max(std::abs(d.x), std::abs(d.y)), 2) << c << ' ' << i;
    }
}

}  // namespace
}  // namespace limpet::geometry
