// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <cmath>
#include <limpet/kinematics/reach.hpp>
#include <stdexcept>

#include "robots.hpp"

namespace limpet::kinematics {
namespace {

using Eigen::Vector3d;

/// Are the positions of prismatic joints within ±1, and may a link carry the other?
void limit(Robot& robot) {
  for (Link& link : robot.links)
    if (link.joint.kind == Joint::Kind::prismatic) link.joint.low = -1, link.joint.high = 1;
}

bool carries(const Robot& robot, std::size_t link, std::size_t other) {
  for (std::optional<std::size_t> i = other; i; i = robot.links[*i].parent)
    if (*i == link) return true;
  return false;
}

/// The largest distance of a sensor or the control point from a revolute axis that moves it, here.
double reach_here(const Robot& robot, const Configuration& at) {
  const Posture posture(robot, at);
  double reach = 0;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (robot.links[i].joint.kind != Joint::Kind::revolute) continue;
    const Vector3d axis = posture.link(i).linear() * robot.links[i].joint.axis;
    const auto look = [&](std::size_t link, const Vector3d& p) {
      if (carries(robot, i, link))
        reach = std::max(reach, axis.cross(p - posture.link(i).translation()).norm());
    };
    for (std::size_t s = 0; s < robot.sensors.size(); ++s)
      look(robot.sensors[s].link, posture.sensor(s).position);
    look(robot.control_point.link, posture.control_point());
  }
  return reach;
}

TEST(LargestReach, IsNeverExceeded) {
  survey::Random random(11);
  for (int trial = 0; trial < 300; ++trial) {
    Robot robot = testing::random_robot(random, 1 + random.below(9));
    limit(robot);
    const double bound = largest_reach(robot);
    ASSERT_TRUE(std::isfinite(bound));
    for (int k = 0; k < 20; ++k) {
      Configuration at = testing::random_configuration(random, robot);
      for (double& position : at) position = std::clamp(position, -1.0, 1.0);
      EXPECT_LE(reach_here(robot, at), bound + 1e-12);
    }
  }
}

TEST(LargestReach, IsExactForAnArmInThePlane) {
  for (int links = 1; links < 6; ++links)
    EXPECT_NEAR(largest_reach(testing::planar_arm(links)), links, 1e-12);
}

TEST(LargestReach, CountsBodies) {
  Robot robot = testing::planar_arm(2);
  robot.links[1].body.push_back({Vector3d(0, 0, 0), Vector3d(0, 3, 0), 0.5});
  EXPECT_NEAR(largest_reach(robot), 4.5, 1e-12);
}

TEST(LargestReach, OfSlidersIsWithinTheirLimits) {
  Robot robot = testing::planar_arm(2);
  robot.links[1].joint = {Joint::Kind::prismatic, Vector3d::UnitX()};
  EXPECT_TRUE(std::isinf(largest_reach(robot)));
  EXPECT_THROW(ceilings_for(robot, 0.2), std::invalid_argument);
  robot.links[1].joint.low = -4, robot.links[1].joint.high = 0.5;
  EXPECT_NEAR(largest_reach(robot), 4, 1e-12);  // 1 − 4, and the link's own 1
  const Ceilings ceilings = ceilings_for(robot, 0.2);
  EXPECT_NEAR(ceilings.prismatic, 0.1, 1e-15);
  EXPECT_NEAR(ceilings.revolute_rad, 0.1 / 4, 1e-15);
}

TEST(LargestReach, NothingTurnsThePointRobot) {
  EXPECT_EQ(largest_reach(point_robot({})), 0);
  EXPECT_EQ(ceilings_for(point_robot({}), 0.2).prismatic, 0.2);
  EXPECT_TRUE(std::isinf(ceilings_for(point_robot({}), 0.2).revolute_rad));
}

TEST(Ceilings, NoJointMovesAPointFartherThanTheRange) {
  survey::Random random(12);
  for (int trial = 0; trial < 200; ++trial) {
    Robot robot = testing::random_chain(random, 1 + random.below(6));
    limit(robot);
    const Ceilings ceilings = ceilings_for(robot, 0.2);
    const Configuration at = Configuration::Zero(static_cast<Eigen::Index>(robot.joint_count()));
    Eigen::Index joint = 0;
    for (const Link& link : robot.links) {
      const bool turns = link.joint.kind == Joint::Kind::revolute;
      Configuration to = at;
      to[joint++] += turns ? ceilings.revolute_rad : ceilings.prismatic;
      const Posture before(robot, at), after(robot, to);
      EXPECT_LE((after.control_point() - before.control_point()).norm(), 0.2 + 1e-12);
    }
  }
}

}  // namespace
}  // namespace limpet::kinematics
