// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <functional>
#include <limpet/kinematics/sensor_patterns.hpp>
#include <numbers>
#include <stdexcept>
#include <string>

#include "robots.hpp"

namespace limpet::kinematics {
namespace {

using Eigen::Vector3d;

TEST(Ring, IsACircleThatLooksOutwards) {
  survey::Random random(1);
  for (int trial = 0; trial < 100; ++trial) {
    Ring r;
    r.link = 3;
    r.centre = testing::random_vector(random, 2);
    r.axis = 3 * testing::random_axis(random);
    r.radius = random.uniform(0, 2);
    r.count = 1 + random.below(12);
    r.tilt_rad = random.uniform(-1.5, 1.5);
    r.turn_rad = random.uniform(-3, 3);
    r.range = 0.2;
    const std::vector<RangeSensor> sensors = ring(r);
    ASSERT_EQ(sensors.size(), r.count);
    const Vector3d axis = r.axis.normalized();
    for (std::size_t i = 0; i < sensors.size(); ++i) {
      const Vector3d arm = sensors[i].position - r.centre;
      EXPECT_EQ(sensors[i].link, 3u);
      EXPECT_EQ(sensors[i].range, 0.2);
      EXPECT_NEAR(arm.norm(), r.radius, 1e-12);
      EXPECT_NEAR(arm.dot(axis), 0, 1e-12);
      EXPECT_NEAR(sensors[i].axis.norm(), 1, 1e-12);
      EXPECT_NEAR(sensors[i].axis.dot(axis), std::sin(r.tilt_rad), 1e-12);
      const Vector3d next = sensors[(i + 1) % r.count].position - r.centre;
      const Eigen::AngleAxisd step(4 * testing::kRightAngle / static_cast<double>(r.count), axis);
      EXPECT_LT((step * arm - next).norm(), 1e-12);  // equal steps, anticlockwise about the axis
    }
  }
}

TEST(Ring, BeginsAtTheCoordinateAxisLeastAlongIt) {
  const auto first = [](const Vector3d& axis) { return ring({.axis = axis, .range = 1})[0].axis; };
  EXPECT_EQ(first(Vector3d::UnitX()), Vector3d::UnitY());
  EXPECT_EQ(first(Vector3d::UnitY()), Vector3d::UnitX());
  EXPECT_EQ(first(Vector3d(0, 0, -2)), Vector3d::UnitX());
}

TEST(Rings, GoFromOneEndToTheOther) {
  Rings r;
  r.from = Vector3d(0, 0, 1), r.to = Vector3d(0, 0, 3);
  r.rings = 5, r.count = 4, r.radius = 0.5, r.range = 0.2;
  const std::vector<RangeSensor> sensors = rings(r);
  ASSERT_EQ(sensors.size(), 20u);
  for (std::size_t i = 0; i < 20; ++i) {
    const std::size_t number = i / 4;
    EXPECT_NEAR(sensors[i].position.z(), 1 + 0.5 * static_cast<double>(number), 1e-12);
  }
  EXPECT_NEAR(sensors[0].axis.dot(sensors[4].axis), std::cos(testing::kRightAngle / 2), 1e-12);
  EXPECT_NEAR(sensors[0].axis.dot(sensors[8].axis), 1, 1e-12);
  r.staggered = false;
  EXPECT_NEAR(rings(r)[0].axis.dot(rings(r)[4].axis), 1, 1e-12);
  r.rings = 1;
  EXPECT_NEAR(rings(r)[0].position.z(), 2, 1e-12);
}

TEST(Patch, IsAGridThatLooksToOneSide) {
  Patch p;
  p.centre = Vector3d(1, 2, 3);
  p.along = Vector3d(2, 0, 0), p.across = Vector3d(0, 0, 4);
  p.columns = 3, p.rows = 2, p.range = 0.2;
  const std::vector<RangeSensor> sensors = patch(p);
  ASSERT_EQ(sensors.size(), 6u);
  EXPECT_EQ(sensors[0].position, Vector3d(0, 2, 1));
  EXPECT_EQ(sensors[1].position, Vector3d(1, 2, 1));
  EXPECT_EQ(sensors[5].position, Vector3d(2, 2, 5));
  for (const RangeSensor& sensor : sensors) EXPECT_EQ(sensor.axis, -Vector3d::UnitY());
  p.columns = p.rows = 1;
  EXPECT_EQ(patch(p)[0].position, p.centre);
}

TEST(Ball, LeavesOutWhatIsInTheCone) {
  const auto count = [](const Vector3d& without, double degrees) {
    return ball({.without = without, .without_rad = degrees * std::numbers::pi / 180, .range = 1}).size();
  };
  EXPECT_EQ(ball({.range = 1}).size(), 26u);
  EXPECT_EQ(ball({.without = Vector3d(0, 0, -3), .range = 1}).size(), 17u);
  EXPECT_EQ(count(Vector3d::UnitX(), 40), 25u);  // the face alone
  EXPECT_EQ(count(Vector3d::UnitX(), 50), 21u);  // and its edges
  EXPECT_EQ(count(Vector3d::UnitX(), 60), 17u);  // and its corners
  EXPECT_EQ(count(Vector3d::UnitX(), 95), 9u);   // and all that is square to it
  EXPECT_EQ(count(Vector3d::UnitX(), 180), 0u);
  for (const RangeSensor& sensor : ball({.without = Vector3d(0, 0, -3), .range = 1}))
    EXPECT_GE(sensor.axis.z(), 0);
}

std::string pattern_complaint(const std::function<void()>& make) {
  try {
    make();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

/// As the thesis's arm: its links are half a resolution wide, and have rings of four at two resolutions.
TEST(Skin, SeesAsDenselyAroundAWideLinkAsAroundAThinOne) {
  constexpr double kSpacing = 0.06;
  std::size_t before = 0;
  for (const double radius : {0.0, 0.015, 0.03, 0.05, 0.09, 0.2}) {
    Robot robot;
    robot.links.resize(1);
    robot.links[0].body = {{Vector3d::Zero(), Vector3d(0, 0, 0.3), radius}};
    const std::vector<RangeSensor> sensors = skin(robot, {.link = 0, .spacing = kSpacing, .range = 0.12});
    std::size_t around = 0;  // of the first ring
    for (const RangeSensor& sensor : sensors) {
      EXPECT_NEAR(sensor.position.head<2>().norm(), radius, 1e-12);
      if (std::abs(sensor.position.z()) < 1e-12) ++around;
    }
    const double between = 2 * std::numbers::pi * (radius + 0.6 * kSpacing) / static_cast<double>(around);
    EXPECT_LE(between, 1.35 * kSpacing) << "from ray to ray, in front of the link";
    EXPECT_GE(around, std::max<std::size_t>(before, 4));
    before = around;
    EXPECT_TRUE(radius != 0.015 || around == 4) << around;
    EXPECT_EQ(skin(robot, {.link = 0, .spacing = kSpacing, .count = 3, .range = 0.12}).size(),
              sensors.size() / around * 3);
  }
}

TEST(SensorPatterns, SayWhatIsWrong) {
  const Vector3d zero = Vector3d::Zero();
  EXPECT_EQ(pattern_complaint([] { ring({}); }), "the range of sensors must be a number more than 0");
  EXPECT_EQ(pattern_complaint([&] { ring({.axis = zero, .range = 1}); }),
            "the axis of a ring must be a finite vector that is not zero");
  EXPECT_EQ(pattern_complaint([] { ring({.radius = -1, .range = 1}); }),
            "the radius of a ring must be 0 or more");
  EXPECT_EQ(pattern_complaint([] { ring({.count = 0, .range = 1}); }), "a ring must have a sensor");
  EXPECT_EQ(pattern_complaint([] { rings({.rings = 0, .range = 1}); }), "there must be a ring");
  EXPECT_EQ(pattern_complaint([&] { rings({.to = zero, .range = 1}); }),
            "the first and the last of rings must not be in one place");
  EXPECT_EQ(pattern_complaint([] { patch({.across = Vector3d(1, 1, 0), .range = 1}); }),
            "the sides of a patch must be orthogonal");
  EXPECT_EQ(pattern_complaint([] { patch({.rows = 0, .range = 1}); }), "a patch must have a sensor");
  EXPECT_EQ(pattern_complaint([&] { ball({.without = zero, .range = 1}); }),
            "the axis of the cone that is left out must be a finite vector that is not zero");
}

}  // namespace
}  // namespace limpet::kinematics
