// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <functional>
#include <limpet/following/thesis/places_internal.hpp>
#include <limpet/following/thesis/progress_internal.hpp>

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;

constexpr double kCeiling = 0.05;  // of point_robot()

/// Steps until progress is insufficient; 0: it never is.
int steps_until_insufficient(const std::function<Vector3d(int)>& place, int steps = 200) {
  const auto robot = kinematics::point_robot({});
  Progress progress(10, 0.1, 0.17);
  for (int i = 0; i < steps; ++i) {
    progress.step(kinematics::Posture(robot, place(i)));
    if (progress.is_insufficient()) return i;
  }
  return 0;
}

TEST(Progress, IsSufficientAlongAStraightWay) {
  EXPECT_EQ(steps_until_insufficient([](int i) { return Vector3d(i * kCeiling, 0, 0); }, 100), 0);
}

TEST(Progress, IsInsufficientAfterThePeriodAtOnePlace) {
  EXPECT_EQ(steps_until_insufficient([](int) { return Vector3d(1, 2, 3); }), 10);
  EXPECT_EQ(steps_until_insufficient([](int i) { return Vector3d(i % 2 * kCeiling, 0, 0); }), 10);
}

TEST(Progress, ACycleOfThreePlacesIsInsufficient) {
  const Vector3d places[] = {{0, 0, 0}, {kCeiling, 0, 0}, {0, kCeiling, 0}};
  EXPECT_EQ(steps_until_insufficient([&](int i) { return places[i % 3]; }), 20);
}

TEST(Progress, AWideCircleIsInsufficientInTheEnd) {
  // A square of 20 ceilings: too wide for the window.
  const auto square = [](int i) {
    const int side = i / 20 % 4;
    const double at = i % 20 * kCeiling, far = 20 * kCeiling;
    return side == 0   ? Vector3d(at, 0, 0)
           : side == 1 ? Vector3d(far, at, 0)
           : side == 2 ? Vector3d(far - at, far, 0)
                       : Vector3d(0, far - at, 0);
  };
  EXPECT_GT(steps_until_insufficient(square), 100);
}

TEST(Progress, IsCountedAnewFromEachNewGoal) {
  const auto robot = kinematics::point_robot({});
  const kinematics::Posture posture(robot, Vector3d::Zero());
  Progress progress(10, 0.1, 0.17);
  for (int i = 0; i < 95; ++i) {
    if (i % 9 == 0) progress.restart(0.1);
    progress.step(posture);
    EXPECT_FALSE(progress.is_insufficient());
    EXPECT_FALSE(progress.stands_still(10));
  }
  for (int i = 0; i < 10; ++i) progress.step(posture);
  EXPECT_TRUE(progress.stands_still(10));
}

TEST(Places, AreWornOutAfterTheirVisits) {
  Places places(0.1, 3);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(places.visit({0.05, -0.05, 0.21}));
  EXPECT_TRUE(places.is_worn({0.01, -0.09, 0.29}));
  EXPECT_FALSE(places.visit({0.05, -0.05, 0.21}));
  EXPECT_TRUE(places.visit({0.05, 0.05, 0.21}));
}

}  // namespace
}  // namespace limpet::following::internal
