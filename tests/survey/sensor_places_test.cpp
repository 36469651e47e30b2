// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <algorithm>
#include <limpet/survey/random.hpp>
#include <limpet/survey/sensor_places.hpp>

namespace limpet::survey {
namespace {

using Eigen::Vector3d;

/// Readings from these places, at random in all directions, 1 to 3 away, noisy along their axes.
std::vector<model::SensorPoint> readings_from(const std::vector<Vector3d>& places, int each, Random& random) {
  std::vector<model::SensorPoint> readings;
  for (const Vector3d& place : places)
    for (int i = 0; i < each; ++i) {
      Vector3d axis;
      do {
        axis = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
      } while (axis.norm() < 0.1 || axis.norm() > 1);
      axis.normalize();
      const double range = random.uniform(1, 3);
      readings.push_back({place + (range + 0.002 * random.normal()) * axis, axis, range});
    }
  return readings;
}

TEST(SensorPlaces, OfScannersThatStandStill) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    std::vector<Vector3d> stands;
    for (std::uint64_t i = 0; i <= random.below(6); ++i)
      stands.push_back({static_cast<double>(i), random.uniform(-1, 1), random.uniform(-1, 1)});
    const auto places = sensor_places(readings_from(stands, 50, random), 64);
    ASSERT_EQ(places.size(), stands.size());
    for (std::size_t i = 0; i < stands.size(); ++i) EXPECT_LT((places[i] - stands[i]).norm(), 0.02);
  }
}

TEST(SensorPlaces, AlongAWayTheyAreFewAndNearEnough) {
  Random random(1);
  std::vector<Vector3d> way;
  for (int i = 0; i < 2000; ++i) way.push_back({0.01 * i, 0, 0});
  const auto readings = readings_from(way, 3, random);
  for (const std::size_t most : {1u, 8u, 64u}) {
    const auto places = sensor_places(readings, most);
    ASSERT_GE(places.size(), 1u);
    ASSERT_LE(places.size(), most);
    if (most < 64) continue;
    for (const Vector3d& from : way)
      EXPECT_TRUE(std::any_of(places.begin(), places.end(),
                              [&](const Vector3d& p) { return (p - from).norm() < 1; }));
  }
}

TEST(SensorPlaces, NoneWhereNoRangeIsKnown) {
  EXPECT_TRUE(sensor_places({{{1, 2, 3}, {0, 0, -1}, 0}}, 64).empty());
  EXPECT_TRUE(sensor_places({}, 64).empty());
}

}  // namespace
}  // namespace limpet::survey
