// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

#include "robots.hpp"

namespace limpet::kinematics {
namespace {

using Eigen::Vector3d;

TEST(Posture, ArmInThePlaneIsWhereAHandWouldDrawIt) {
  Robot arm = testing::planar_arm(2);
  arm.sensors.push_back({1, Vector3d(0.5, 0, 0), Vector3d::UnitY(), 1});

  const Posture straight(arm, Eigen::Vector2d(0, 0));
  EXPECT_TRUE(straight.control_point().isApprox(Vector3d(2, 0, 0)));

  const Posture bent(arm, Eigen::Vector2d(testing::kRightAngle, -testing::kRightAngle));
  EXPECT_TRUE(bent.link(1).translation().isApprox(Vector3d(0, 1, 0)));
  EXPECT_TRUE(bent.control_point().isApprox(Vector3d(1, 1, 0)));
  EXPECT_TRUE(bent.sensor(0).position.isApprox(Vector3d(0.5, 1, 0)));
  EXPECT_TRUE(bent.sensor(0).axis.isApprox(Vector3d::UnitY()));
  EXPECT_EQ(bent.sensor(0).range, 1);

  const Posture folded(arm, Eigen::Vector2d(testing::kRightAngle, 2 * testing::kRightAngle));
  EXPECT_LT(folded.control_point().norm(), 1e-12);
}

TEST(Posture, SliderOnATurntableSlidesWhereItPoints) {
  Robot robot;
  robot.links.resize(2);
  robot.links[0].joint = {Joint::Kind::revolute, Vector3d::UnitZ()};
  robot.links[1].parent = 0;
  robot.links[1].mounting.translation() = Vector3d(0, 0, 1);
  robot.links[1].joint = {Joint::Kind::prismatic, Vector3d::UnitX()};
  robot.control_point.link = 1;
  const Posture posture(robot, Eigen::Vector2d(testing::kRightAngle, 3));
  EXPECT_TRUE(posture.control_point().isApprox(Vector3d(0, 3, 1)));
  EXPECT_TRUE(posture.jacobian().isApprox(Eigen::Matrix<double, 3, 2>{{-3, 0}, {0, 1}, {0, 0}}, 1e-12));
}

TEST(Posture, LinksAreTheProductsOfAllThatCarriesThem) {
  survey::Random random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const Robot robot = testing::random_robot(random, 1 + random.below(9));
    const Configuration at = testing::random_configuration(random, robot);
    const Posture posture(robot, at);
    for (std::size_t i = 0; i < robot.links.size(); ++i) {
      Eigen::Affine3d pose = Eigen::Affine3d::Identity();  // from the link down to the world
      for (std::optional<std::size_t> link = i; link; link = robot.links[*link].parent) {
        const Joint& joint = robot.links[*link].joint;
        Eigen::Index before = 0;
        for (std::size_t k = 0; k < *link; ++k) before += robot.links[k].joint.kind != Joint::Kind::fixed;
        if (joint.kind == Joint::Kind::prismatic) pose = Eigen::Translation3d(at[before] * joint.axis) * pose;
        if (joint.kind == Joint::Kind::revolute) pose = Eigen::AngleAxisd(at[before], joint.axis) * pose;
        pose = Eigen::Affine3d(robot.links[*link].mounting.matrix()) * pose;
      }
      EXPECT_TRUE(posture.link(i).matrix().isApprox(pose.matrix(), 1e-12)) << "link " << i;
    }
  }
}

TEST(Posture, SensorPointIsSoFarAlongTheSensingAxis) {
  survey::Random random(2);
  const Robot robot = testing::random_robot(random, 6);
  const Posture posture(robot, testing::random_configuration(random, robot));
  for (std::size_t i = 0; i < robot.sensors.size(); ++i) {
    const Posture::Sensor sensor = posture.sensor(i);
    const Eigen::Isometry3d& link = posture.link(robot.sensors[i].link);
    EXPECT_TRUE((link.inverse() * sensor.position).isApprox(robot.sensors[i].position, 1e-12));
    EXPECT_TRUE((link.linear().transpose() * sensor.axis).isApprox(robot.sensors[i].axis, 1e-12));
    const model::SensorPoint point = posture.sensor_point(i, 0.125);
    EXPECT_EQ(point.position, sensor.position + 0.125 * sensor.axis);
    EXPECT_EQ(point.axis, sensor.axis);
    EXPECT_EQ(point.range, 0.125);
  }
}

TEST(Posture, JacobianIsTheDerivativeOfTheControlPoint) {
  survey::Random random(3);
  const double h = 1e-6;
  for (int trial = 0; trial < 100; ++trial) {
    const Robot robot = testing::random_robot(random, 1 + random.below(9));
    const Configuration at = testing::random_configuration(random, robot);
    const Eigen::Matrix3Xd jacobian = Posture(robot, at).jacobian();
    ASSERT_EQ(jacobian.cols(), at.size());
    for (Eigen::Index j = 0; j < at.size(); ++j) {
      const Configuration step = h * Configuration::Unit(at.size(), j);
      const Vector3d difference =
          (Posture(robot, at + step).control_point() - Posture(robot, at - step).control_point()) / (2 * h);
      EXPECT_LT((jacobian.col(j) - difference).norm(), 1e-8) << "joint " << j;
    }
  }
}

TEST(Posture, ConfigurationsThatDoNotFitAreRefused) {
  const Robot arm = testing::planar_arm(2);
  EXPECT_THROW(Posture(arm, Eigen::Vector3d(0, 0, 0)), std::invalid_argument);
  EXPECT_THROW(Posture(arm, Configuration()), std::invalid_argument);
  EXPECT_THROW(Posture(arm, Eigen::Vector2d(0, std::numeric_limits<double>::quiet_NaN())),
               std::invalid_argument);
}

}  // namespace
}  // namespace limpet::kinematics
