// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/following/links/sensed_space.hpp>

#include "links_scene.hpp"

namespace limpet::following {
namespace {

using Eigen::Vector3d;
using kinematics::Configuration;
using kinematics::Posture;

constexpr double kCell = 0.1;

TEST(SensedSpace, IsWhatRaysWentThroughAndLinksWereIn) {
  survey::Random random(3);
  const model::Model nothing(model::Parameters{});
  for (int trial = 0; trial < 100; ++trial) {
    kinematics::Robot robot = robots::random_chain(random, 3);
    for (auto& link : robot.links) link.body = {{Vector3d::Zero(), robots::random_vector(random, 0.6), 0.03}};
    const Posture posture(robot, robots::random_configuration(random, robot));
    const double read = random.uniform(0, 0.2);
    const std::vector<model::SensorPoint> set = {posture.sensor_point(1, read)};
    SensedSpace sensed(kCell);
    const auto body = kinematics::moving_body(robot, 0);
    sensed.add({nothing, {}, posture, set}, body, 0.05);
    for (std::size_t i = 0; i < robot.sensors.size(); ++i) {
      const auto sensor = posture.sensor(i);
      const double free = i == 1 ? read : sensor.range;
      for (double t = 0; t <= 1; t += 0.25) {  // corners of cells may be cut off
        const Vector3d at = sensor.position + t * free * sensor.axis, off = kCell / 2 * sensor.axis;
        EXPECT_TRUE(sensed.holds(at) || sensed.holds(at - off) || sensed.holds(at + off));
      }
    }
    for (const auto& part : body) EXPECT_TRUE(sensed.holds(kinematics::in_world(part, posture)));
  }
}

TEST(SensedSpace, EndsWhereARayMetSomethingAndWhereNoneWent) {
  kinematics::Robot robot;
  robot.links.resize(1);
  robot.links[0].joint.kind = kinematics::Joint::Kind::prismatic;
  robot.sensors = {{0, Vector3d::Zero(), Vector3d::UnitX(), 1}};
  const Posture posture(robot, Configuration::Zero(1));
  const model::Model nothing(model::Parameters{});
  const std::vector<model::SensorPoint> set = {posture.sensor_point(0, 0.45)};
  SensedSpace sensed(kCell);
  sensed.add({nothing, {}, posture, set}, {}, 0.05);
  EXPECT_TRUE(sensed.holds(Vector3d(0.44, 0.05, 0.05)));
  EXPECT_FALSE(sensed.holds(Vector3d(0.55, 0, 0)));
  EXPECT_FALSE(sensed.holds(Vector3d(0.2, 0.15, 0)));
  EXPECT_FALSE(sensed.holds(model::Capsule{Vector3d(0.1, 0, 0), Vector3d(0.9, 0, 0), 0}));
  const std::size_t cells = sensed.cells();
  for (int i = 0; i < 10; ++i) sensed.add({nothing, {}, posture, set}, {}, 0.05);
  EXPECT_EQ(sensed.cells(), cells) << "it does not grow with time";
}

/// Cells along the axis of a switch count as seen to be free only while it sees nothing.
TEST(SensedSpace, HoldsTheAxesOfSwitchesThatSeeNothing) {
  kinematics::Robot robot;
  robot.links.resize(1);
  robot.switches = {{0, Vector3d::Zero(), Vector3d::UnitX(), 1}, {0, Vector3d::Zero(), Vector3d::UnitY(), 1}};
  const model::Model nothing{model::Parameters{}};
  const Posture posture(robot, Configuration());
  const std::vector<std::size_t> seeing = {1};
  SensedSpace space(0.1);
  space.add({nothing, {}, posture, {}, seeing}, {}, 0.05);
  for (const double along : {0.15, 0.55, 0.95}) {
    EXPECT_TRUE(space.holds(Vector3d(along, 0, 0)));
    EXPECT_FALSE(space.holds(Vector3d(0, along, 0)));
  }
}

/// A link that is wide does not fit where a thin one has been.
TEST(SensedSpace, HoldsWhatALinkIsNotItsAxisAlone) {
  kinematics::Robot robot;
  robot.links.resize(1);
  robot.links[0].joint.kind = kinematics::Joint::Kind::prismatic;
  robot.links[0].body = {{Vector3d(0, 0, 0.05), Vector3d(0.8, 0, 0.05), 0.01}};
  const Posture posture(robot, Configuration::Zero(1));
  const model::Model nothing{model::Parameters{}};
  SensedSpace thin(kCell), wide(kCell);
  thin.add({nothing, {}, posture, {}}, kinematics::moving_body(robot, 0), 0.05);
  model::Capsule capsule{Vector3d(0.1, 0, 0.05), Vector3d(0.7, 0, 0.05), 0.01};
  EXPECT_TRUE(thin.holds(capsule));
  capsule.radius = 0.25;
  EXPECT_FALSE(thin.holds(capsule));
  robot.links[0].body[0].radius = 0.25;
  wide.add({nothing, {}, posture, {}}, kinematics::moving_body(robot, 0), 0.05);
  EXPECT_TRUE(wide.holds(model::Capsule{Vector3d(0, 0, 0.05), Vector3d(0.8, 0, 0.05), 0.25}));
}

}  // namespace
}  // namespace limpet::following
