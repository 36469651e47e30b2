// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <cmath>
#include <limpet/survey/random.hpp>
#include <vector>

namespace limpet::survey {
namespace {

TEST(Random, SameSeedSameNumbersOtherSeedOtherNumbers) {
  Random a(7), b(7), c(8);
  int equal = 0;
  for (int i = 0; i < 100; ++i) {
    const std::uint64_t word = a.next();
    EXPECT_EQ(word, b.next());
    equal += word == c.next();
  }
  EXPECT_EQ(equal, 0);
}

TEST(Random, NumbersAreFixedForEver) {
  // splitmix64 from 0 is published: its first numbers seed the state.
  Random random(0);
  EXPECT_EQ(random.next(), 0x99ec5f36cb75f2b4u);
}

TEST(Random, UniformIsUniform) {
  Random random(1);
  const int draws = 200'000;
  double sum = 0, square = 0, least = 1, most = 0;
  for (int i = 0; i < draws; ++i) {
    const double x = random.uniform();
    sum += x;
    square += x * x;
    least = std::min(least, x);
    most = std::max(most, x);
  }
  EXPECT_NEAR(sum / draws, 0.5, 0.003);
  EXPECT_NEAR(square / draws, 1.0 / 3, 0.003);
  EXPECT_GE(least, 0);
  EXPECT_LT(most, 1);
}

TEST(Random, BelowReachesEveryNumberEquallyOften) {
  Random random(2);
  std::vector<int> seen(7, 0);
  for (int i = 0; i < 70'000; ++i) ++seen.at(random.below(7));
  for (const int count : seen) EXPECT_NEAR(count, 10'000, 500);
}

TEST(Random, NormalHasTheMomentsOfTheNormalDistribution) {
  Random random(3);
  const int draws = 400'000;
  double m1 = 0, m2 = 0, m4 = 0;
  int beyond_three = 0;
  for (int i = 0; i < draws; ++i) {
    const double x = random.normal();
    m1 += x;
    m2 += x * x;
    m4 += x * x * x * x;
    beyond_three += std::abs(x) > 3;
  }
  EXPECT_NEAR(m1 / draws, 0, 0.008);
  EXPECT_NEAR(m2 / draws, 1, 0.012);
  EXPECT_NEAR(m4 / draws, 3, 0.1);
  EXPECT_NEAR(beyond_three / static_cast<double>(draws), 0.0027, 0.0004);
}

}  // namespace
}  // namespace limpet::survey
