// Copyright the limpet authors. GPL-3.0-or-later.
//
// Hoover's score on cases small enough to be worked out by hand.
#include <gtest/gtest.h>

#include <limits>
#include <limpet/evaluation/region_score.hpp>
#include <limpet/survey/random.hpp>
#include <stdexcept>
#include <vector>

namespace limpet::evaluation {
namespace {

/// `points` points of the true region that were found in the found one.
struct Shared {
  std::int64_t truth, found, points;
};

RegionScore score(const std::vector<Shared>& shared, const RegionScoreOptions& options = {}) {
  RegionOverlaps overlaps;
  for (const Shared& s : shared) {
    for (std::int64_t i = 0; i < s.points; ++i) overlaps.add(s.truth, s.found);
  }
  return score_regions(overlaps, options);
}

void expect_counts(const RegionScore& s, int correct, int over, int under, int missed, int noise) {
  EXPECT_EQ(s.correct, correct);
  EXPECT_EQ(s.over_segmented, over);
  EXPECT_EQ(s.under_segmented, under);
  EXPECT_EQ(s.missed, missed);
  EXPECT_EQ(s.noise, noise);
  // Every region has one fate.
  EXPECT_EQ(s.correct + s.over_segmented + s.merged + s.missed, static_cast<int>(s.truth.size()));
  EXPECT_EQ(s.correct + s.pieces + s.under_segmented + s.noise, static_cast<int>(s.found.size()));
}

TEST(RegionScore, ExactMatchWhateverTheLabels) {
  const RegionScore s = score({{1, 70, 10}, {2, -3, 20}, {900, 1, 30}});
  expect_counts(s, 3, 0, 0, 0, 0);
  EXPECT_EQ(s.truth[0].found, std::vector<std::int64_t>{70});
  EXPECT_EQ(s.found[0].label, -3);
  EXPECT_EQ(s.found[0].truth, std::vector<std::int64_t>{2});
  EXPECT_EQ(s.purity, 1);
  EXPECT_EQ(s.covered, 1);
  EXPECT_EQ(s.points, 60);
}

TEST(RegionScore, CorrectDownToTheThresholdAndNotBelow) {
  // 80 of 100 points of each: just enough on both sides; the rest is in no region.
  expect_counts(score({{1, 1, 80}, {1, kNoRegion, 20}, {kNoRegion, 1, 20}}), 1, 0, 0, 0, 0);
  // 79 of 99.
  expect_counts(score({{1, 1, 79}, {1, kNoRegion, 20}}), 0, 0, 0, 1, 1);
  expect_counts(score({{1, 1, 79}, {kNoRegion, 1, 20}}), 0, 0, 0, 1, 1);
  expect_counts(score({{1, 1, 79}, {1, kNoRegion, 20}}, {.overlap = 0.79}), 1, 0, 0, 0, 0);
}

TEST(RegionScore, OverSegmented) {
  const RegionScore s = score({{1, 1, 50}, {1, 2, 35}, {1, kNoRegion, 15}, {kNoRegion, 2, 5}});
  expect_counts(s, 0, 1, 0, 0, 0);
  EXPECT_EQ(s.pieces, 2);
  EXPECT_EQ(s.truth[0].fate, RegionFate::over_segmented);
  EXPECT_EQ(s.truth[0].found, (std::vector<std::int64_t>{1, 2}));
  EXPECT_EQ(s.truth[0].main_found, 1);
  EXPECT_DOUBLE_EQ(s.truth[0].covered(), 0.85);
  EXPECT_DOUBLE_EQ(s.truth[0].covered_by_main(), 0.5);
  EXPECT_DOUBLE_EQ(s.found[1].purity(), 35.0 / 40);
  // A third of it is not found at all: missed, and the pieces are noise.
  expect_counts(score({{1, 1, 50}, {1, 2, 30}, {1, kNoRegion, 40}}), 0, 0, 0, 1, 2);
}

TEST(RegionScore, UnderSegmented) {
  const RegionScore s = score({{1, 5, 50}, {2, 5, 30}, {3, 5, 20}});
  expect_counts(s, 0, 0, 1, 0, 0);
  EXPECT_EQ(s.merged, 3);
  EXPECT_EQ(s.found[0].truth, (std::vector<std::int64_t>{1, 2, 3}));
  EXPECT_EQ(s.found[0].main_true, 1);
  EXPECT_DOUBLE_EQ(s.found[0].purity(), 0.5);
  EXPECT_EQ(s.covered, 1);
  EXPECT_DOUBLE_EQ(s.purity, 0.5);
  // Half of it lies over no true region.
  expect_counts(score({{1, 5, 50}, {2, 5, 30}, {kNoRegion, 5, 80}}), 0, 0, 0, 2, 1);
}

TEST(RegionScore, MissedAndNoise) {
  const RegionScore s = score({{1, kNoRegion, 40}, {kNoRegion, 7, 30}, {2, 2, 10}});
  expect_counts(s, 1, 0, 0, 1, 1);
  EXPECT_EQ(s.truth[0].main_found, kNoRegion);
  EXPECT_EQ(s.found[1].main_true, kNoRegion);
  EXPECT_EQ(s.found[1].purity(), 0);
  EXPECT_DOUBLE_EQ(s.covered, 0.2);
  EXPECT_DOUBLE_EQ(s.purity, 0.25);
}

TEST(RegionScore, OfSeveralReadingsTheHigherAverageOverlapStands) {
  // True 1 has 100 points: 82 in found 1, 18 in found 2. Correct with found 1: (82/100 + 82/82) / 2 = 0.91;
  // over-segmented into both: (82/82 + 18/18 + 100/100) / 3 = 1.
  expect_counts(score({{1, 1, 82}, {1, 2, 18}}), 0, 1, 0, 0, 0);
  // The mirror image: found 1 holds true 1 and true 2.
  expect_counts(score({{1, 1, 82}, {2, 1, 18}}), 0, 0, 1, 0, 0);
  // 95 and 5, and found 2 goes one point beyond: correct (95/100 + 1) / 2 = 0.975;
  // over (1 + 5/6 + 1) / 3 = 0.944.
  expect_counts(score({{1, 1, 95}, {1, 2, 5}, {kNoRegion, 2, 1}}), 1, 0, 0, 0, 1);
  // 85 and 15: correct (0.85 + 1) / 2 = 0.925; over (1 + 15/16 + 1) / 3 = 0.979.
  expect_counts(score({{1, 1, 85}, {1, 2, 15}, {kNoRegion, 2, 1}}), 0, 1, 0, 0, 0);
  // The mirror images of these two.
  expect_counts(score({{1, 1, 95}, {2, 1, 5}, {2, kNoRegion, 1}}), 1, 0, 0, 1, 0);
  expect_counts(score({{1, 1, 85}, {2, 1, 15}, {2, kNoRegion, 1}}), 0, 0, 1, 0, 0);
  // Found 2 is 6 beyond: 20 of 26 is below 0.8, so there is only the correct reading left.
  expect_counts(score({{1, 1, 80}, {1, 2, 20}, {kNoRegion, 2, 6}}), 1, 0, 0, 0, 1);
}

TEST(RegionScore, WhatALosingReadingLeavesIsMissedOrNoise) {
  // True 1 (100 points) is in found 1 (82) and 2 (18); found 1 also holds all 20 of true 2.
  // Under 1 and 2: (82/100 + 20/20 + 102/102) / 3 = 0.94; over into 1 and 2: (82/102 + 1 + 1) / 3 = 0.935;
  // correct: (82/100 + 82/102) / 2 = 0.81.
  const RegionScore s = score({{1, 1, 82}, {1, 2, 18}, {2, 1, 20}});
  expect_counts(s, 0, 0, 1, 0, 1);
  EXPECT_EQ(s.found[1].fate, RegionFate::unmatched);
}

TEST(RegionScore, TiesGoToTheCorrectReading) {
  // Correct: (153/170 + 1) / 2 = 0.95; over (1 + 17/20 + 1) / 3 = 0.95. One point more in found 2's excess
  // and the correct reading is the higher, one less and it is the lower.
  expect_counts(score({{1, 1, 153}, {1, 2, 17}, {kNoRegion, 2, 3}}), 1, 0, 0, 0, 1);
  expect_counts(score({{1, 1, 153}, {1, 2, 17}, {kNoRegion, 2, 4}}), 1, 0, 0, 0, 1);
  expect_counts(score({{1, 1, 153}, {1, 2, 17}, {kNoRegion, 2, 2}}), 0, 1, 0, 0, 0);
  // Of two equal shares the region with the lower label is the main one.
  const RegionScore s = score({{4, 1, 10}, {4, 2, 10}, {3, 9, 5}, {5, 9, 5}});
  EXPECT_EQ(s.truth[1].main_found, 1);
  EXPECT_EQ(s.found[2].main_true, 3);
}

TEST(RegionScore, SmallRegionsAreLeftOut) {
  const std::vector<Shared> shared = {
      {1, 1, 100}, {2, 2, 5}, {3, kNoRegion, 4}, {1, 3, 3}, {kNoRegion, 4, 2}};
  expect_counts(score(shared), 1, 1, 0, 1, 1);
  // Their points are no part of anything: found 2 is gone with true 2.
  const RegionScore s = score(shared, {.min_true = 10});
  expect_counts(s, 0, 1, 0, 0, 1);
  EXPECT_EQ(s.left_out, 9);
  EXPECT_EQ(s.points, 105);
  // Small found regions are none: true 1 is 100 of 103 in found 1.
  expect_counts(score(shared, {.min_true = 10, .min_found = 4}), 1, 0, 0, 0, 0);
  EXPECT_EQ(score({}).truth.size(), 0u);
}

TEST(RegionScore, TheWholeOverlapLeavesExactReadings) {
  expect_counts(score({{1, 1, 10}, {2, 2, 10}, {2, 3, 10}, {3, 4, 9}, {3, 1, 1}}, {.overlap = 1}), 0, 1, 0, 2,
                2);
}

TEST(RegionScore, AnOverlapThatCouldMatchTwiceIsRefused) {
  for (const double overlap : {0.5, 0.0, -1.0, 1.01, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(score({{1, 1, 1}}, {.overlap = overlap}), std::invalid_argument) << overlap;
  }
}

/// Truth and finding change places: what was over-segmented is under-segmented, what was missed is noise.
TEST(RegionScore, TurnsRoundWithItsArguments) {
  const std::uint64_t seed = 41;
  RecordProperty("seed", std::to_string(seed));
  survey::Random random(seed);
  int instances = 0;
  for (int run = 0; run < 500; ++run) {
    std::vector<Shared> shared, turned;
    const auto label = [&] {
      const std::uint64_t l = random.below(5);
      return l == 0 ? kNoRegion : static_cast<std::int64_t>(l);
    };
    for (std::uint64_t left = 1 + random.below(8); left > 0; --left) {
      const std::int64_t n = label(), m = label();
      const auto points = static_cast<std::int64_t>(1 + random.below(random.below(2) == 0 ? 50 : 1000));
      shared.push_back({n, m, points});
      turned.push_back({m, n, points});
    }
    const RegionScore a = score(shared), b = score(turned);
    expect_counts(b, a.correct, a.under_segmented, a.over_segmented, a.noise, a.missed);
    EXPECT_EQ(a.merged, b.pieces) << "run " << run << " of seed " << seed;
    instances += a.over_segmented + a.under_segmented;
  }
  EXPECT_GT(instances, 50) << "a law that nothing tried";
}

}  // namespace
}  // namespace limpet::evaluation
