// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/evaluation/joint_levers_internal.hpp>
#include <limpet/survey/random.hpp>

#include "arm_worlds.hpp"

namespace limpet::evaluation {
namespace {

using Eigen::Vector3d;
using kinematics::Configuration;
using kinematics::Posture;
using kinematics::Robot;

/// A slide between two turns, that reaches from −0.5 to 0.25.
Robot sliding_arm() {
  Robot robot = testing::planar_arm();
  kinematics::Link slide;
  slide.parent = 1;
  slide.mounting.translation() = Vector3d(0.5, 0.25, 0);
  slide.joint = {kinematics::Joint::Kind::prismatic, Vector3d::UnitX(), -0.5, 0.25};
  robot.links.push_back(slide);
  kinematics::Link turn;
  turn.parent = 2;
  turn.mounting.translation() = Vector3d(0, 0.5, 0);
  turn.joint = {kinematics::Joint::Kind::revolute, Vector3d::UnitY()};
  robot.links.push_back(turn);
  return robot;
}

Configuration random_of(const Robot& robot, survey::Random& random) {
  Configuration at(static_cast<Eigen::Index>(robot.joint_count()));
  Eigen::Index k = 0;
  for (const kinematics::Link& link : robot.links)
    if (link.joint.kind != kinematics::Joint::Kind::fixed)
      at[k++] = random.uniform(std::max(link.joint.low, -3.0), std::min(link.joint.high, 3.0));
  return at;
}

/// No point moves farther than the levers say, nor leaves the ball.
TEST(JointLevers, BoundHowFarAPointMoves) {
  survey::Random random(1);
  for (const Robot& robot : {sliding_arm(), testing::planar_arm(), kinematics::arm()})
    for (int i = 0; i < 2000; ++i) {
      const std::size_t link = static_cast<std::size_t>(random.below(robot.links.size()));
      const Vector3d point(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      const Configuration from = random_of(robot, random), to = random_of(robot, random);
      const Vector3d before = Posture(robot, from).link(link) * point,
                     after = Posture(robot, to).link(link) * point;
      EXPECT_LE((after - before).norm(),
                joint_levers(robot, link, point).dot((to - from).cwiseAbs()) + 1e-12);
      const ReachBall ball = reach_of_point(robot, link, point);
      EXPECT_LE((before - ball.centre).norm(), ball.radius + 1e-12);
    }
}

TEST(JointLevers, AreTheLengthsOfAnArmStretchedOut) {
  const Robot arm = testing::planar_arm();
  EXPECT_EQ(joint_levers(arm, 1, Vector3d::UnitX()), Eigen::Vector2d(2, 1));
  EXPECT_EQ(joint_levers(arm, 0, Vector3d::UnitX()), Eigen::Vector2d(1, 0));
  EXPECT_EQ(reach_of_point(arm, 1, Vector3d::UnitX()).radius, 2);
}

}  // namespace
}  // namespace limpet::evaluation
