// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/kinematics/arm.hpp>
#include <limpet/kinematics/reach.hpp>
#include <numbers>
#include <stdexcept>

#include "robots.hpp"

namespace limpet::kinematics {
namespace {

using Eigen::Vector3d;
using Vector6d = Eigen::Matrix<double, 6, 1>;

Vector6d angles(double a, double b, double c, double d, double e, double f) {
  return (Vector6d() << a, b, c, d, e, f).finished();
}

TEST(Arm, IsAsTheThesisSays) {
  const Robot robot = arm();
  EXPECT_EQ(robot.joint_count(), 6u);
  EXPECT_NEAR(robot.ceilings.revolute_rad, 0.0663, 0.0001);
  ASSERT_EQ(robot.sensors.size(), 17u + 116u);
  std::vector<int> around(robot.links.size(), 0);
  int at_control_point = 0;
  for (const RangeSensor& sensor : robot.sensors) {
    EXPECT_EQ(sensor.range, 0.2);
    if (sensor.position == robot.control_point.position)
      ++at_control_point;
    else
      ++around[sensor.link];
  }
  EXPECT_EQ(at_control_point, 17);
  EXPECT_EQ(around, (std::vector<int>{0, 0, 40, 0, 40, 0, 36}));
}

TEST(Arm, PosesThatAHandWouldDraw) {
  const Robot robot = arm();
  const auto control_point = [&](const Vector6d& at) { return Posture(robot, at).control_point(); };
  EXPECT_EQ(control_point(Vector6d::Zero()), Vector3d(0, 0, 4));  // straight out: exactly 4
  EXPECT_LT((control_point(angles(0, testing::kRightAngle, 0, 0, 0, 0)) - Vector3d(3, 0, 1)).norm(), 1e-12);
  EXPECT_LT((control_point(angles(-testing::kRightAngle, 0, 0, 0, 0, 0)) - Vector3d(0, 3, 1)).norm(), 1e-12);
  EXPECT_LT(
      (control_point(angles(0, testing::kRightAngle, 0, -testing::kRightAngle, 0, 0)) - Vector3d(1, 0, 3))
          .norm(),
      1e-12);
  // Three right angles lead round a square, to the foot of link 1.
  const double r = testing::kRightAngle;
  EXPECT_LT((control_point(angles(0, r, 0, r, 0, r)) - Vector3d(0, 0, 0)).norm(), 1e-12);
}

TEST(Arm, ReachesNoFartherThanItsLinks) {
  survey::Random random(1);
  const Robot robot = arm();
  for (int trial = 0; trial < 1000; ++trial) {
    const Vector3d x = Posture(robot, testing::random_configuration(random, robot)).control_point();
    EXPECT_LE((x - Vector3d(0, 0, 1)).norm(), 3 + 1e-12);
  }
}

TEST(Arm, CeilingIsTheThesis) {
  EXPECT_NEAR(largest_reach(arm()), 3, 1e-12);
  // "γ was determined using the method described in Section 3.3": 0.2 / 3 is 3.82°, and the thesis has 3.8°.
  const double degrees = ceilings_for(arm(), 0.2).revolute_rad * 180 / std::numbers::pi;
  EXPECT_NEAR(degrees, 3.82, 0.005);
  EXPECT_LT(arm().ceilings.revolute_rad, ceilings_for(arm(), 0.2).revolute_rad);
}

TEST(Arm, SensorsOfLinksAreOnThemAndLookAway) {
  const Robot robot = arm();
  for (const RangeSensor& sensor : robot.sensors) {
    const Vector3d outwards(sensor.position.x(), sensor.position.y(), 0);
    if (sensor.position == robot.control_point.position) {
      EXPECT_GE(sensor.axis.z(), 0);
    } else {
      EXPECT_NEAR(outwards.norm(), 0.05, 1e-15);
      EXPECT_LT((sensor.axis - outwards / outwards.norm()).norm(), 1e-12);
      const model::Capsule& body = robot.links[sensor.link].body[0];
      EXPECT_GE(sensor.position.z(), body.a.z());
      EXPECT_LE(sensor.position.z(), body.b.z() + 1e-12);
    }
  }
}

TEST(Arm, LeavesTheControlPointBare) {
  const model::Capsule tip = arm().links.back().body[0];
  EXPECT_NEAR((Vector3d(0, 0, 1) - tip.b).norm() - tip.radius, 0.1, 1e-12);
}

TEST(Arm, ScalesAsAWhole) {
  survey::Random random(2);
  const Robot one = arm(), other = arm(scaled({}, 0.4));
  const Configuration at = testing::random_configuration(random, one);
  EXPECT_LT((Posture(other, at).control_point() - 0.4 * Posture(one, at).control_point()).norm(), 1e-12);
  for (std::size_t i = 0; i < one.sensors.size(); ++i) {
    const Posture::Sensor a = Posture(one, at).sensor(i), b = Posture(other, at).sensor(i);
    EXPECT_LT((0.4 * a.position - b.position).norm(), 1e-12);
    EXPECT_LT((a.axis - b.axis).norm(), 1e-12);
    EXPECT_DOUBLE_EQ(b.range, 0.08);
  }
  EXPECT_NEAR(largest_reach(other), 1.2, 1e-12);
}

TEST(Arm, IsPlacedAsAWhole) {
  survey::Random random(3);
  const Robot one = arm();
  const Eigen::Isometry3d base = testing::random_pose(random);
  const Configuration at = testing::random_configuration(random, one);
  const Robot moved = placed(one, base);
  for (std::size_t i = 0; i < one.links.size(); ++i)
    EXPECT_TRUE(Posture(moved, at).link(i).isApprox(base * Posture(one, at).link(i), 1e-12));
}

TEST(Arm, SizesThatMakeNoArmAreRefused) {
  EXPECT_THROW(arm({.link_length = 0}), std::invalid_argument);
  EXPECT_THROW(arm({.radius = -1}), std::invalid_argument);
  EXPECT_THROW(arm({.radius = 0.95}), std::invalid_argument);
  EXPECT_THROW(arm({.sensing_range = 0}), std::invalid_argument);
  EXPECT_THROW(arm({.bare_tip = -0.1}), std::invalid_argument);
  EXPECT_THROW(arm({.ceiling_rad = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace limpet::kinematics
