// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/kinematics/urdf.hpp>

#include "../temporary_folder.hpp"
#include "capsules.hpp"
#include "robots.hpp"
#include "urdf_text.hpp"

namespace limpet::kinematics {
namespace {

using Eigen::Vector3d;
using testing::joint;
using testing::link;
using testing::robot_of;
using testing::shape;

Robot parse(const std::string& text, const UrdfOptions& options = {}) {
  return parse_urdf(text, "robot.urdf", options);
}

/// A slider on a turntable, with a gripper of two fingers, one of which mimics the other.
const std::string kGripper = robot_of(
    link("floor") + link("table") + link("slide") + link("hand") + link("left") + link("right") +
    joint("plinth", "fixed", "floor", "table", R"(<origin xyz="0 0 1" rpy="0 0 0"/>)") +
    joint("turn", "continuous", "table", "slide", R"(<axis xyz="0 0 2"/><limit velocity="3" effort="1"/>)") +
    joint(
        "reach", "prismatic", "slide", "hand",
        R"(<origin xyz="1 0 0"/><axis xyz="1 0 0"/><limit lower="-0.5" upper="2" velocity="0" effort="1"/>)") +
    joint("grip", "prismatic", "hand", "left",
          R"(<axis xyz="0 1 0"/><limit lower="0.1" upper="0.4" velocity="1" effort="1"/>)") +
    joint("other", "prismatic", "hand", "right",
          R"(<axis xyz="0 -1 0"/><limit lower="0" upper="1" velocity="1" effort="1"/>
                      <mimic joint="grip" multiplier="2" offset="0.01"/>)"));

TEST(Urdf, ReadsAChainWithWhatIsFixedToIt) {
  const Robot robot = parse(kGripper, {.tip = "hand"});
  EXPECT_EQ(robot.name, "robot");
  std::vector<std::string> names;
  for (const Link& one : robot.links) names.push_back(one.name);
  EXPECT_EQ(names, (std::vector<std::string>{"floor", "table", "slide", "hand", "left", "right"}));
  EXPECT_EQ(robot.joint_count(), 2u);
  EXPECT_EQ(robot.control_point.link, 3u);

  const Joint& turn = robot.links[2].joint;
  EXPECT_EQ(turn.kind, Joint::Kind::revolute);
  EXPECT_EQ(turn.axis, Vector3d::UnitZ());
  EXPECT_TRUE(std::isinf(turn.low) && std::isinf(turn.high));
  EXPECT_EQ(turn.max_velocity, 3);
  const Joint& reach = robot.links[3].joint;
  EXPECT_EQ(reach.kind, Joint::Kind::prismatic);
  EXPECT_EQ(reach.low, -0.5);
  EXPECT_EQ(reach.high, 2);
  EXPECT_TRUE(std::isinf(reach.max_velocity));  // 0 in the file

  const Posture posture(robot, Eigen::Vector2d(std::acos(0.0), 0.5));
  EXPECT_LT((posture.control_point() - Vector3d(0, 1.5, 1)).norm(), 1e-12);
}

TEST(Urdf, LocksWhatIsNotOnTheChain) {
  const auto fingers = [](const UrdfOptions& options) {
    const Robot robot = parse(kGripper, options);
    EXPECT_EQ(robot.links[4].joint.kind, Joint::Kind::fixed);
    return Eigen::Vector2d(robot.links[4].mounting.translation().y(),
                           robot.links[5].mounting.translation().y());
  };
  EXPECT_LT((fingers({.tip = "hand"}) - Eigen::Vector2d(0.1, -0.21)).norm(), 1e-15);  // 0.1: the nearest to 0
  EXPECT_LT((fingers({.tip = "hand", .locked = {{"grip", 0.3}}}) - Eigen::Vector2d(0.3, -0.61)).norm(),
            1e-15);
  EXPECT_LT((fingers({.tip = "hand", .locked = {{"other", 1}}}) - Eigen::Vector2d(0.1, -1)).norm(), 1e-15);
}

TEST(Urdf, BeginsAtAnyBase) {
  const Robot robot = parse(kGripper, {.base = "slide", .tip = "left", .locked = {{"other", 0.5}}});
  EXPECT_EQ(robot.links[0].name, "slide");
  EXPECT_FALSE(robot.links[0].parent);
  EXPECT_TRUE(robot.links[0].mounting.matrix().isIdentity());
  EXPECT_EQ(robot.joint_count(), 2u);
}

TEST(Urdf, TheTipIsTheFarthestLinkWhenThereIsOne) {
  const std::string text =
      robot_of(link("a") + link("b") + link("c") + link("camera") + joint("ab", "continuous", "a", "b") +
               joint("bc", "fixed", "b", "c") + joint("eye", "fixed", "a", "camera"));
  const Robot robot = parse(text);
  EXPECT_EQ(robot.links[robot.control_point.link].name, "c");
}

TEST(Urdf, ShapesBecomeCapsules) {
  const auto body = [](const std::string& shapes, const UrdfOptions& options = {}) {
    return parse(robot_of(link("a", shapes) + link("b") + joint("ab", "continuous", "a", "b")), options)
        .links[0]
        .body;
  };
  const auto sphere = body(shape(R"(<sphere radius="2"/>)", R"(<origin xyz="1 2 3"/>)"));
  ASSERT_EQ(sphere.size(), 1u);
  EXPECT_EQ(sphere[0].a, Vector3d(1, 2, 3));
  EXPECT_EQ(sphere[0].b, sphere[0].a);
  EXPECT_EQ(sphere[0].radius, 2);

  const std::string along_x = R"(<origin xyz="1 0 0" rpy="0 1.5707963267948966 0"/>)";
  for (const std::string kind : {"cylinder", "capsule"}) {
    const auto rod = body(shape("<" + kind + R"( length="4" radius="0.5"/>)", along_x));
    ASSERT_EQ(rod.size(), 1u);
    EXPECT_LT((rod[0].a - Vector3d(-1, 0, 0)).norm(), 1e-12);
    EXPECT_LT((rod[0].b - Vector3d(3, 0, 0)).norm(), 1e-12);
    EXPECT_EQ(rod[0].radius, 0.5);
  }
  // What others write for a capsule is one.
  const std::string end = R"(<sphere radius="0.5"/>)";
  EXPECT_EQ(body(shape(end, R"(<origin xyz="0 0 2"/>)") + shape(R"(<cylinder length="4" radius="0.5"/>)") +
                 shape(end, R"(<origin xyz="0 0 -2"/>)"))
                .size(),
            1u);
  EXPECT_EQ(body("").size(), 0u);
  const model::Capsule given{Vector3d(0, 0, 0), Vector3d(0, 0, 1), 0.1};
  EXPECT_EQ(body(shape(R"(<mesh filename="no.stl"/>)"), {.shapes = {{"a", {given}}}})[0].radius, 0.1);
}

TEST(Urdf, BoxesLieInTheirCapsules) {
  survey::Random random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const Vector3d size(random.uniform(0.01, 1), random.uniform(0.01, 1), random.uniform(0.01, 1));
    const auto text = [](const Vector3d& v) {
      return std::to_string(v.x()) + " " + std::to_string(v.y()) + " " + std::to_string(v.z());
    };
    const Vector3d at = testing::random_vector(random, 1), rpy = testing::random_vector(random, 3);
    const Robot robot =
        parse(robot_of(link("a", shape("<box size=\"" + text(size) + "\"/>",
                                       "<origin xyz=\"" + text(at) + "\" rpy=\"" + text(rpy) + "\"/>")) +
                       link("b") + joint("ab", "continuous", "a", "b")));
    const Eigen::Matrix3d turn =
        (Eigen::AngleAxisd(rpy.z(), Vector3d::UnitZ()) * Eigen::AngleAxisd(rpy.y(), Vector3d::UnitY()) *
         Eigen::AngleAxisd(rpy.x(), Vector3d::UnitX()))
            .toRotationMatrix();
    ASSERT_EQ(robot.links[0].body.size(), 1u);
    const model::Capsule& capsule = robot.links[0].body[0];
    std::vector<Vector3d> corners;
    for (int i = 0; i < 8; ++i)
      corners.emplace_back(at + turn * Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)
                                           .cwiseProduct((size.array() - 2e-6).matrix() / 2));
    for (const Vector3d& corner : corners) EXPECT_TRUE(testing::is_in(corner, capsule));
    EXPECT_LE(testing::excess(capsule, corners), 2 * capsule.radius + 1e-5);
  }
}

class UrdfMeshTest : public limpet::testing::TemporaryFolder {};

TEST_F(UrdfMeshTest, MeshesAreScaledPlacedAndHeld) {
  write("tetra.stl", "");
  const std::vector<Vector3d> p = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  UrdfOptions options;
  std::string asked;
  options.load_mesh = [&](const std::string& file) {
    asked = file;
    return std::vector<Vector3d>{p[0], p[2], p[1], p[0], p[1], p[3], p[1], p[2], p[3], p[2], p[0], p[3]};
  };
  const std::string mesh =
      shape(R"(<mesh filename="package://some/where/tetra.stl" scale="2 3 4"/>)", R"(<origin xyz="5 6 7"/>)");
  const std::string text = robot_of(link("a", mesh) + link("b") + joint("ab", "continuous", "a", "b"));
  options.package_paths = {path("")};
  const Robot robot = parse_urdf(text, path("robot.urdf"), options);
  EXPECT_EQ(asked, path("tetra.stl"));
  for (const Vector3d& corner : p)
    EXPECT_TRUE(
        testing::is_in_any(Vector3d(5, 6, 7) + corner.cwiseProduct(Vector3d(2, 3, 4)), robot.links[0].body));
}

TEST(Urdf, WhatIsForTheEyeOrForDynamicsIsNotLookedAt) {
  const std::string text = robot_of(
      link("a", "<visual><geometry><blob/></geometry></visual><inertial><mass value=\"heavy\"/></inertial>") +
      link("b") + joint("ab", "continuous", "a", "b") + "<material/><gazebo/><transmission/>");
  EXPECT_EQ(parse(text).joint_count(), 1u);
}

std::string chosen_tip(const std::string& links_and_joints) {
  const Robot robot = parse(robot_of(links_and_joints));
  return robot.links[robot.control_point.link].name;
}

/// Where nobody names the tip, it is the link that is named as one, or the end of the chain that moves most.
TEST(Urdf, TheTipIsTheOneThatIsNamedSoOrThatMovesMost) {
  const std::string arm = link("a") + link("b") + link("c") + joint("ab", "continuous", "a", "b") +
                          joint("bc", "continuous", "b", "c");
  const std::string camera =
      link("eye") + link("lens") + joint("ae", "fixed", "a", "eye") + joint("el", "fixed", "eye", "lens");
  EXPECT_EQ(chosen_tip(arm + camera), "c") << "as far as the lens, but more joints";
  const std::string flange = link("flange") + joint("cf", "fixed", "c", "flange");
  const std::string plate = link("plate") + joint("cp", "fixed", "c", "plate");
  EXPECT_EQ(chosen_tip(arm + flange + plate), "flange");
  const std::string tool = link("arm_tool0") + joint("ct", "fixed", "c", "arm_tool0");
  EXPECT_EQ(chosen_tip(arm + flange + plate + tool), "arm_tool0") << "a better name";
  const std::string finger = link("finger") + joint("ff", "continuous", "flange", "finger");
  EXPECT_EQ(chosen_tip(arm + flange + finger), "flange") << "not the finger, that moves more";
  EXPECT_EQ(chosen_tip(arm + plate + link("tcp") + joint("at", "fixed", "a", "tcp")), "plate")
      << "a name at the foot of the arm is another's";
}

}  // namespace
}  // namespace limpet::kinematics
