// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <functional>
#include <limpet/kinematics/arm.hpp>
#include <stdexcept>

#include "robots.hpp"

namespace limpet::kinematics {
namespace {

using Eigen::Vector3d;

int coordinates_not_zero(const Vector3d& v) { return static_cast<int>((v.array().abs() > 1e-12).count()); }

TEST(PointRobot, HasTheDirectionsOfFacesEdgesAndCornersOfACube) {
  const Robot robot = point_robot({});
  ASSERT_EQ(robot.sensors.size(), 26u);
  for (std::size_t i = 0; i < 26; ++i) {
    const RangeSensor& sensor = robot.sensors[i];
    EXPECT_EQ(coordinates_not_zero(sensor.axis), i < 6 ? 1 : i < 18 ? 2 : 3);
    EXPECT_NEAR(sensor.axis.norm(), 1, 1e-15);
    EXPECT_NEAR(sensor.axis.cwiseAbs().maxCoeff() * std::sqrt(coordinates_not_zero(sensor.axis)), 1, 1e-15);
    EXPECT_EQ(sensor.range, 0.2);
    for (std::size_t j = 0; j < i; ++j) EXPECT_LT(sensor.axis.dot(robot.sensors[j].axis), 0.9);
  }
}

TEST(PointRobot, IsWhereItsConfigurationSaysAndTurnedAsItHeads) {
  survey::Random random(7);
  const Eigen::Quaterniond heading(testing::random_pose(random).linear());
  const Robot robot = point_robot({.sensing_range = 0.3, .ceiling = 0.07, .heading = heading});
  const Vector3d place(3, -2, 0.5);
  const Posture posture(robot, place);
  EXPECT_EQ(robot.joint_count(), 3u);
  EXPECT_EQ(robot.ceilings.prismatic, 0.07);
  EXPECT_EQ(posture.control_point(), place);
  EXPECT_TRUE(posture.jacobian().isIdentity(1e-15));
  for (std::size_t i = 0; i < 26; ++i) {
    EXPECT_EQ(posture.sensor(i).position, place);
    EXPECT_TRUE(posture.sensor(i).axis.isApprox(heading * robot.sensors[i].axis, 1e-12));
  }
  EXPECT_TRUE(actuator_changes(posture, Vector3d(0.7, 0, 0)).isApprox(Vector3d(0.07, 0, 0)));
}

TEST(PointRobot, NeedsARangeAndACeiling) {
  EXPECT_THROW(point_robot({.sensing_range = 0}), std::invalid_argument);
  EXPECT_THROW(point_robot({.ceiling = -1}), std::invalid_argument);
}

/// What require_sound says of a point robot with one thing spoilt; empty: nothing.
std::string complaint(const std::function<void(Robot&)>& spoil) {
  Robot robot = point_robot({});
  spoil(robot);
  try {
    require_sound(robot);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

/// What is at the control point stays a sensor; all else is a switch in the same place, in the same order.
TEST(WithSwitches, ChangesNothingButWhatIsOnTheLinks) {
  const Robot before = arm(), after = with_switches(before);
  EXPECT_EQ(after.sensors.size(), 17u);
  ASSERT_EQ(after.sensors.size() + after.switches.size(), before.sensors.size());
  std::size_t sensors = 0, switches = 0;
  for (const RangeSensor& was : before.sensors) {
    const bool stays = was.link == before.control_point.link && was.position == before.control_point.position;
    const auto same = [&was](const auto& is) {
      return is.link == was.link && is.position == was.position && is.axis == was.axis &&
             is.range == was.range;
    };
    EXPECT_TRUE(stays ? same(after.sensors[sensors++]) : same(after.switches[switches++]));
  }
  EXPECT_NO_THROW(require_sound(after));
  const Robot again = with_switches(after);
  EXPECT_EQ(again.switches.size(), after.switches.size()) << "twice is once";
  EXPECT_EQ(with_switches(point_robot({})).sensors.size(), 26u);
}

/// The field touches the switch, and reaches as far as its range.
TEST(Posture, KnowsWhereASwitchAndItsFieldAre) {
  survey::Random random(3);
  for (int trial = 0; trial < 100; ++trial) {
    const Robot robot = with_switches(arm());
    const Posture posture(robot, testing::random_configuration(random, robot));
    const std::size_t i = random.below(robot.switches.size());
    const ProximitySwitch& mounted = robot.switches[i];
    const Posture::Switch s = posture.proximity_switch(i);
    EXPECT_EQ(s.position, posture.link(mounted.link) * mounted.position);
    EXPECT_NEAR((s.field_centre - s.position).norm(), mounted.range / 2, 1e-12);
    EXPECT_LT((s.position + s.range / 2 * s.axis - s.field_centre).norm(), 1e-12);
  }
}

/// A slider on a turntable on a post, with a plate between them.
Robot slider_on_a_turntable() {
  Robot robot;
  robot.links.resize(4);
  robot.links[1].joint.kind = Joint::Kind::revolute;
  robot.links[3].joint.kind = Joint::Kind::prismatic;
  for (std::size_t i = 1; i < 4; ++i) robot.links[i].parent = i - 1;
  robot.ceilings = {0.25, 0.5};
  return robot;
}

TEST(ForEachMovingJoint, NumbersThoseThatMoveInOrder) {
  const Robot robot = slider_on_a_turntable();
  std::vector<Eigen::Index> numbers;
  std::vector<const Joint*> joints;
  for_each_moving_joint(robot, [&](Eigen::Index k, const Joint& joint) {
    numbers.push_back(k);
    joints.push_back(&joint);
  });
  EXPECT_EQ(numbers, (std::vector<Eigen::Index>{0, 1}));
  EXPECT_EQ(joints, (std::vector<const Joint*>{&robot.links[1].joint, &robot.links[3].joint}));
}

TEST(ForEachMovingJoint, ComesToAsManyAsTheRobotHasAndMayChangeThem) {
  survey::Random random(9);
  for (int trial = 0; trial < 100; ++trial) {
    Robot robot = testing::random_robot(random, 1 + random.below(9));
    for_each_moving_joint(robot, [](Eigen::Index k, Joint& joint) { joint.low = static_cast<double>(k); });
    std::size_t next = 0;
    for (const Link& link : robot.links) {
      if (link.joint.kind == Joint::Kind::fixed)
        EXPECT_TRUE(std::isinf(link.joint.low));
      else
        EXPECT_EQ(link.joint.low, static_cast<double>(next++));
    }
    EXPECT_EQ(next, robot.joint_count());
  }
}

TEST(Ceilings, AreOfAJointsKind) {
  const Robot robot = slider_on_a_turntable();
  EXPECT_EQ(robot.ceilings.of(robot.links[1].joint), 0.5);
  EXPECT_EQ(robot.ceilings.of(robot.links[3].joint), 0.25);
}

TEST(RequireSound, SaysWhatIsWrongAndWhere) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(complaint([](Robot&) {}), "");
  EXPECT_EQ(complaint([](Robot& r) { r.links[1].parent = 1; }), "link 1 (y): its parent must come before it");
  EXPECT_EQ(complaint([](Robot& r) { r.links[3].mounting.linear() *= 2; }),
            "link 3 (body): its mounting must be a finite translation and a rotation");
  EXPECT_EQ(complaint([](Robot& r) { r.links[3].mounting.linear() *= -1; }),
            "link 3 (body): its mounting must be a finite translation and a rotation");
  EXPECT_EQ(complaint([](Robot& r) { r.links[2].joint.axis = Vector3d(1, 1, 0); }),
            "link 2 (z): the axis of its joint must be a unit vector");
  EXPECT_EQ(complaint([](Robot& r) { r.links[0].joint.low = 1, r.links[0].joint.high = 0; }),
            "link 0 (x): the limits of its joint are out of order");
  EXPECT_EQ(complaint([](Robot& r) {
              r.links[0].body.push_back({Vector3d::Zero(), Vector3d::Zero(), -1});
            }).substr(0, 33),
            "link 0 (x): a part of its body mu");
  EXPECT_EQ(complaint([](Robot& r) { r.control_point.link = 4; }), "the control point is on no link");
  EXPECT_EQ(complaint([=](Robot& r) { r.control_point.position.x() = nan; }),
            "the control point has no finite position");
  EXPECT_EQ(complaint([](Robot& r) { r.sensors[5].link = 9; }), "sensor 5: is on no link");
  EXPECT_EQ(complaint([=](Robot& r) { r.sensors[5].position.y() = nan; }),
            "sensor 5: has no finite position");
  EXPECT_EQ(complaint([](Robot& r) { r.sensors[5].axis.setZero(); }),
            "sensor 5: its axis must be a unit vector");
  EXPECT_EQ(complaint([=](Robot& r) { r.sensors[25].range = nan; }), "sensor 25: its range must be positive");
  const auto switched = [](const ProximitySwitch& s) {
    return complaint([&s](Robot& r) { r.switches = {{0, Vector3d::Zero(), Vector3d::UnitX(), 1}, s}; });
  };
  const Vector3d x = Vector3d::UnitX();
  EXPECT_EQ(switched({3, x, x, 1}), "");
  EXPECT_EQ(switched({4, x, x, 1}), "switch 1: is on no link");
  EXPECT_EQ(switched({0, nan * x, x, 1}), "switch 1: has no finite position");
  EXPECT_EQ(switched({0, x, 2 * x, 1}), "switch 1: its axis must be a unit vector");
  EXPECT_EQ(switched({0, x, x, 0}), "switch 1: its range must be positive");
  EXPECT_EQ(switched({0, x, x, std::numeric_limits<double>::infinity()}),
            "switch 1: its range must be finite");
  EXPECT_EQ(complaint([](Robot& r) { r.ceilings.revolute_rad = 0; }), "ceilings must be positive");
  EXPECT_EQ(complaint([](Robot& r) { r = Robot(); }), "the control point is on no link");
}

}  // namespace
}  // namespace limpet::kinematics
