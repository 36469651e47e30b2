// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limpet/following/sensor_watch.hpp>
#include <limpet/survey/random.hpp>
#include <optional>
#include <stdexcept>

#include "random_places.hpp"
#include "simulated_run.hpp"

namespace limpet::following {
namespace {

using Eigen::Vector3d;

TEST(SensorWatch, FindsASensorThatSaysTheSameEverywhere) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    survey::Random random(seed);
    SensorWatch watch(kLambda, 2);
    Vector3d place = Vector3d::Zero();
    int set = 0;
    while (set < 1000 && !watch.is_stuck(1, place, 0.1)) place += 0.02 * random_vector(random), ++set;
    EXPECT_LT(set, 1000);
    EXPECT_GT(set, 3) << "places in a plane prove nothing";
    EXPECT_EQ(watch.stuck(), std::vector<std::size_t>{1});
    EXPECT_TRUE(watch.is_stuck(1, place, 0.07)) << "it stays so";
  }
}

TEST(SensorWatch, BelievesASensorThatMovesAlongAPlane) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    survey::Random random(seed);
    const Vector3d along = random_vector(random), across = random_vector(random);
    SensorWatch watch(kLambda, 1);
    for (int set = 0; set < 500; ++set)
      EXPECT_FALSE(watch.is_stuck(0, random.normal() * along + random.normal() * across, 0.1));
  }
}

TEST(SensorWatch, AnotherDistanceOrNoneBeginsAnew) {
  survey::Random random(1);
  SensorWatch watch(kLambda, 2);
  for (int set = 0; set < 500; ++set) {
    const Vector3d place = random_vector(random);
    // Three places lie in a plane; the fourth would not.
    EXPECT_FALSE(watch.is_stuck(0, place, set % 3 == 0 ? std::nullopt : std::optional(0.1)));
    EXPECT_FALSE(watch.is_stuck(1, place, set % 3 == 0 ? 0.1 + 1e-15 : 0.1));
  }
  EXPECT_TRUE(watch.stuck().empty());
}

TEST(SensorWatch, RefusesAResolutionThatIsNotPositive) {
  EXPECT_THROW(SensorWatch(0, 1), std::invalid_argument);
}

/// Exact readings of faces that are parallel, at places that aims put at the same heights over them.
TEST(SensorWatch, BelievesAllSensorsOfARunOverAStaircase) {
  for (const std::uint64_t seed : {1, 2}) {
    SCOPED_TRACE(seed);
    RunOptions options;
    options.shape = "step";
    options.strategy = Strategy::frontier;
    options.seed = seed;
    options.random_heading = false;
    EXPECT_EQ(run_following(options).stuck_sensors, std::vector<std::size_t>{});
  }
}

}  // namespace
}  // namespace limpet::following
