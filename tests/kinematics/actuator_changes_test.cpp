// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "robots.hpp"

namespace limpet::kinematics {
namespace {

using Eigen::Vector3d;

double length_of(const Robot& robot, const Configuration& changes, Joint::Kind kind) {
  double sum = 0;
  Eigen::Index joint = 0;
  for (const Link& link : robot.links) {
    if (link.joint.kind == Joint::Kind::fixed) continue;
    if (link.joint.kind == kind) sum += changes[joint] * changes[joint];
    ++joint;
  }
  return std::sqrt(sum);
}

bool reaches_everywhere(const Posture& posture) {
  if (posture.configuration().size() < 3) return false;
  const Eigen::Matrix3Xd jacobian = posture.jacobian();
  const Eigen::Matrix3d squares = jacobian * jacobian.transpose();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(squares).eigenvalues()[0] > 0.05 * 0.05;
}

/// What is left of the motion of one joint when what moves the control point is taken out of it.
Eigen::VectorXd still_motion(const Eigen::Matrix3Xd& jacobian, Eigen::Index joint) {
  Eigen::VectorXd still = Eigen::VectorXd::Unit(jacobian.cols(), joint);
  const Eigen::Matrix3d squares = jacobian * jacobian.transpose();
  const Vector3d weights = squares.inverse() * jacobian.col(joint);
  still -= jacobian.transpose() * weights;
  return still;
}

TEST(ActuatorChanges, MoveTheControlPointAsAsked) {
  survey::Random random(4);
  int tried = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Robot robot = testing::random_chain(random, 3 + random.below(6));
    const Posture posture(robot, testing::random_configuration(random, robot));
    const Vector3d motion = testing::random_vector(random, 0.1);
    if (!reaches_everywhere(posture)) continue;
    ++tried;
    const Configuration changes = actuator_changes(posture, motion);
    EXPECT_LT((posture.jacobian() * changes - motion).norm(), 1e-9);
    // The smallest: orthogonal to every motion of the joints that leaves the control point where it is.
    const Eigen::Matrix3Xd jacobian = posture.jacobian();
    for (Eigen::Index i = 0; i < jacobian.cols(); ++i)
      EXPECT_LT(std::abs(still_motion(jacobian, i).dot(changes)), 1e-9);
  }
  EXPECT_GT(tried, 200);
}

TEST(ActuatorChanges, AreOneForEachJointOfAnyTree) {
  survey::Random random(8);
  for (int trial = 0; trial < 300; ++trial) {
    const Robot robot = testing::random_robot(random, 1 + random.below(6));  // some have no joint at all
    const Posture posture(robot, testing::random_configuration(random, robot));
    const Vector3d motion = testing::random_vector(random, 0.1);
    const Configuration changes = actuator_changes(posture, motion);
    ASSERT_EQ(static_cast<std::size_t>(changes.size()), robot.joint_count());
    EXPECT_LE((posture.jacobian() * changes - motion).norm(), motion.norm() + 1e-9);
  }
}

TEST(ActuatorChanges, MoveAsNearAsTheyCanWhereTheControlPointCannotGo) {
  const Robot arm = testing::planar_arm(2);
  const Posture bent(arm, Eigen::Vector2d(0.3, 0.8));
  const Configuration changes = actuator_changes(bent, Vector3d(0.01, 0.02, 0.5));
  EXPECT_LT((bent.jacobian() * changes - Vector3d(0.01, 0.02, 0)).norm(), 1e-12);  // z is out of its plane
  const Posture straight(arm, Eigen::Vector2d(0, 0));
  EXPECT_LT(actuator_changes(straight, Vector3d(-0.1, 0, 0)).norm(), 1e-12);
}

TEST(ActuatorChanges, KeepBothCeilingsByOneFactor) {
  survey::Random random(5);
  int shortened = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Robot robot = testing::random_chain(random, 3 + random.below(6));
    const Configuration at = testing::random_configuration(random, robot);
    const Vector3d motion = testing::random_vector(random, 0.5);
    const Configuration free = actuator_changes(Posture(robot, at), motion);
    robot.ceilings.prismatic = random.uniform(0.01, 0.5);
    robot.ceilings.revolute_rad = random.uniform(0.01, 0.5);
    const Configuration kept = actuator_changes(Posture(robot, at), motion);
    const double prismatic = length_of(robot, free, Joint::Kind::prismatic) / robot.ceilings.prismatic;
    const double revolute = length_of(robot, free, Joint::Kind::revolute) / robot.ceilings.revolute_rad;
    const double over = std::max({1.0, prismatic, revolute});
    shortened += over > 1;
    EXPECT_LT((kept - free / over).norm(), 1e-12);
  }
  EXPECT_GT(shortened, 50);
}

TEST(ActuatorChanges, NeverLeadBeyondALimit) {
  survey::Random random(6);
  for (int trial = 0; trial < 300; ++trial) {
    Robot robot = testing::random_chain(random, 3 + random.below(6));
    const Configuration at = testing::random_configuration(random, robot);
    Eigen::Index joint = 0;
    for (Link& link : robot.links) {
      if (link.joint.kind == Joint::Kind::fixed) continue;
      link.joint.low = at[joint] - 0.1 * static_cast<double>(random.below(3));
      link.joint.high = at[joint] + 0.1 * static_cast<double>(random.below(3));
      ++joint;
    }
    const Configuration to = at + actuator_changes(Posture(robot, at), testing::random_vector(random, 0.5));
    joint = 0;
    for (const Link& link : robot.links) {
      if (link.joint.kind == Joint::Kind::fixed) continue;
      EXPECT_GE(to[joint], link.joint.low - 1e-12);
      EXPECT_LE(to[joint], link.joint.high + 1e-12);
      ++joint;
    }
  }
}

TEST(LengthsByKind, AreOfTheChangesOfEachKindAlone) {
  Robot robot;
  robot.links.resize(5);
  robot.links[0].joint.kind = robot.links[2].joint.kind = Joint::Kind::prismatic;
  robot.links[3].joint.kind = robot.links[4].joint.kind = Joint::Kind::revolute;
  const LengthsByKind lengths = lengths_by_kind(robot, Eigen::Vector4d(3, -4, 5, 12));
  EXPECT_EQ(lengths.prismatic, 5);
  EXPECT_EQ(lengths.revolute_rad, 13);
  EXPECT_EQ(lengths_by_kind(testing::planar_arm(2), Eigen::Vector2d(3, 4)).prismatic, 0);
}

TEST(LengthsByKind, AreTogetherTheLengthOfAllChanges) {
  survey::Random random(10);
  for (int trial = 0; trial < 100; ++trial) {
    const Robot robot = testing::random_robot(random, 1 + random.below(9));
    const Configuration changes = testing::random_configuration(random, robot);
    const LengthsByKind lengths = lengths_by_kind(robot, changes);
    EXPECT_NEAR(std::hypot(lengths.prismatic, lengths.revolute_rad), changes.norm(), 1e-12);
    EXPECT_NEAR(lengths.prismatic, length_of(robot, changes, Joint::Kind::prismatic), 1e-12);
  }
}

TEST(WithinLimits, IsTheNearestThatKeepsThem) {
  Robot arm = testing::planar_arm(3);
  arm.links[0].joint.kind = Joint::Kind::fixed;
  arm.links[1].joint.low = -0.5;
  arm.links[2].joint.high = 0.5;
  EXPECT_EQ(within_limits(arm, Eigen::Vector2d(-1, 1)), Eigen::Vector2d(-0.5, 0.5));
  EXPECT_EQ(within_limits(arm, Eigen::Vector2d(1, -1)), Eigen::Vector2d(1, -1));
}

TEST(ActuatorChanges, LeadBackFromBeyondALimitButNotOn) {
  Robot arm = testing::planar_arm(2);
  arm.links[0].joint.high = 0.5;
  const Posture beyond(arm, Eigen::Vector2d(0.6, 0));
  EXPECT_EQ(limited(beyond, Eigen::Vector2d(0.1, 0.1)).norm(), 0);
  EXPECT_EQ(limited(beyond, Eigen::Vector2d(-0.1, 0.1)), Eigen::Vector2d(-0.1, 0.1));
}

}  // namespace
}  // namespace limpet::kinematics
