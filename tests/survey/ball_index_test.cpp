// Copyright the limpet authors. GPL-3.0-or-later.
//
// BallIndex against looking at every ball.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limpet/survey/ball_index_internal.hpp>
#include <limpet/survey/random.hpp>

namespace limpet::survey {
namespace {

TEST(BallIndex, FindsEveryBallThatAPointLiesIn) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto place = [&] {
      return Eigen::Vector3d(random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5));
    };
    std::vector<std::pair<Eigen::Vector3d, double>> balls;
    BallIndex index;
    for (std::uint32_t i = 0; i < 200; ++i) {
      balls.emplace_back(place(), std::exp2(random.uniform(-8, 2)));
      if (i % 10 == 0) balls.back().second = 1;  // a power of two, and a centre on the cells' walls
      if (i % 20 == 0) balls.back().first = {2, 4, -2};
      index.add(balls.back().first, balls.back().second, i);
    }
    for (int k = 0; k < 500; ++k) {
      const auto& [centre, radius] = balls[random.below(balls.size())];
      const Eigen::Vector3d p = k % 2 == 0 ? place() : Eigen::Vector3d(centre + radius / 10 * place());
      std::vector<std::uint32_t> found, truth;
      index.for_each_near(p, [&](std::uint32_t ball) { found.push_back(ball); });
      for (std::uint32_t i = 0; i < balls.size(); ++i)
        if ((p - balls[i].first).norm() <= balls[i].second) truth.push_back(i);
      std::sort(found.begin(), found.end());
      EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end()) << "each once";
      EXPECT_TRUE(std::includes(found.begin(), found.end(), truth.begin(), truth.end()));
    }
  }
}

TEST(BallIndex, HoldsWhatIsFarAwayAndWhatIsTiny) {
  BallIndex index;
  const std::vector<std::pair<Eigen::Vector3d, double>> balls{
      {{1e300, 0, -1e300}, 1}, {{1e300, 1, 0}, 1e299}, {{0, 0, 0}, 1e-310}, {{-1e18, 0, 0}, 1e-3}};
  for (std::uint32_t i = 0; i < balls.size(); ++i) index.add(balls[i].first, balls[i].second, i);
  for (std::uint32_t i = 0; i < balls.size(); ++i) {
    bool found = false;
    index.for_each_near(balls[i].first, [&](std::uint32_t ball) { found |= ball == i; });
    EXPECT_TRUE(found) << i;
  }
}

}  // namespace
}  // namespace limpet::survey
