// Copyright the limpet authors. GPL-3.0-or-later.
//
// Where arms begin: what holds of every placement, and what is said when there is none.
#include <gtest/gtest.h>

#include <algorithm>
#include <limpet/app/arm_placement.hpp>
#include <limpet/app/robot_file.hpp>
#include <limpet/evaluation/true_surface.hpp>
#include <limpet/following/links/link_motion.hpp>
#include <limpet/kinematics/arm.hpp>
#include <limpet/kinematics/body.hpp>
#include <numbers>

#include "../data_folder.hpp"

namespace limpet::app {
namespace {

using Eigen::Vector3d;
using kinematics::Posture;

simulation::BuiltWorld world_of(const std::string& shape, double largest_side,
                                const std::string& direction = "") {
  simulation::WorldDescription wanted;
  wanted.mesh = shape;
  const simulation::Bounds bounds = simulation::bounds_of(*simulation::build_world(wanted, 1).truth);
  wanted.placement.scale = largest_side / (bounds.high - bounds.low).maxCoeff();
  wanted.placement.position = Vector3d(0.3, -2, 5);
  if (!direction.empty()) {
    wanted.direction = Vector3d(-0.6, 0.5, -0.62);
    wanted.pitch = largest_side / 80;
    wanted.initial_occluded = true;
  }
  return simulation::build_world(wanted, 1);
}

/// What goes with a robot whose sensors have this range.
PlacementOptions options_for(double sensing_range, std::uint64_t seed) {
  const auto following = following::usual_parameters(sensing_range / 4);
  const auto links = following::usual_link_parameters(following, following::Redundancy::programme);
  PlacementOptions options;
  options.follow_distance = following.follow_distance;
  options.link_distance = 1.5 * links.least_distance;
  options.own_distance = 2 * links.own_distance;
  options.spared = links.spared;
  options.seed = seed;
  return options;
}

/// Nearest distance of any part of the body, but for what is spared, from a mesh.
double link_distance(const Posture& posture, const evaluation::TrueSurface& surface, double spared) {
  double least = 1e9;
  for (const kinematics::BodyPart& part : kinematics::moving_body(posture.robot(), spared)) {
    const model::Capsule capsule = kinematics::in_world(part, posture);
    least = std::min(least, surface.distance_along(capsule.a, capsule.b) - capsule.radius);
  }
  return least;
}

bool feels(const Posture& posture, const simulation::World& world) {
  for (std::size_t i = 0; i < posture.robot().sensors.size(); ++i) {
    const Posture::Sensor sensor = posture.sensor(i);
    if (world.sight(sensor.position, sensor.axis, sensor.range)) return true;
  }
  return false;
}

void expect_good(const kinematics::Robot& robot, const simulation::BuiltWorld& world,
                 const PlacementOptions& options) {
  const ArmPlacement placement = place_beside(robot, world, options);
  const Posture posture(placement.robot, placement.start);
  const evaluation::TrueSurface surface(*world.truth);
  EXPECT_NEAR(surface.distance(posture.control_point()), options.follow_distance,
              2e-3 * options.follow_distance);
  EXPECT_GE(link_distance(posture, surface, options.spared), options.link_distance - 1e-9);
  for (const auto& [i, j] :
       kinematics::pairs_to_keep_apart(robot, kinematics::moving_body(robot, options.spared))) {
    const auto body = kinematics::moving_body(placement.robot, options.spared);
    EXPECT_GT(kinematics::distance_between(kinematics::in_world(body[i], posture),
                                           kinematics::in_world(body[j], posture)),
              0);
  }
  EXPECT_TRUE(feels(posture, *world.world));
  Eigen::Index joint = 0;
  for (const kinematics::Link& link : robot.links) {
    if (link.joint.kind == kinematics::Joint::Kind::fixed) continue;
    EXPECT_GE(placement.start[joint], link.joint.low) << link.name;
    EXPECT_LE(placement.start[joint], link.joint.high) << link.name;
    ++joint;
  }
  const double up =
      placement.robot.links[0].mounting.translation().z() - robot.links[0].mounting.translation().z();
  const simulation::Bounds bounds = simulation::bounds_of(*world.truth);
  if (options.object_place == ObjectPlace::on_ground)
    EXPECT_NEAR(up, bounds.low.z(), 1e-12);
  else
    EXPECT_LT(up, bounds.low.z()) << "the object can be felt from below";
  EXPECT_EQ(place_beside(robot, world, options).start, placement.start);
}

TEST(ArmPlacement, TheArmFeelsEachObjectAndIsClearOfIt) {
  const kinematics::Robot arm = kinematics::arm();
  for (const std::string shape : {"cube", "box", "L", "step", "cross", "octahedron"})
    for (const ObjectPlace place : {ObjectPlace::on_ground, ObjectPlace::in_reach}) {
      SCOPED_TRACE(shape);
      PlacementOptions options = options_for(0.2, 3);
      options.object_place = place;
      expect_good(arm, world_of(shape, 1), options);
    }
}

TEST(ArmPlacement, RealRobotsFeelEachObjectAndAreClearOfIt) {
  std::vector<std::string> paths;
  for (const char* folder : {"robot_urdf", "robot_panda", "robot_ur5"})
    paths.push_back((limpet::testing::data_folder() / folder).string());
  if (!std::filesystem::exists(paths.front())) GTEST_SKIP() << "no robots in " << paths.front();
  for (const std::string name : {"panda", "iiwa14", "ur5"}) {
    const RobotFile file = read_robot(LIMPET_SOURCE_DIR "/robots/" + name + ".toml", paths);
    for (const std::string shape : {"cube", "L", "octahedron"})
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        SCOPED_TRACE(::testing::Message() << name << " " << shape << " " << seed);
        PlacementOptions options = options_for(file.sensing_range, seed);
        options.posture = file.start;
        expect_good(file.robot, world_of(shape, 0.3), options);
      }
  }
}

/// Of a range image the start is at a part that it shows.
TEST(ArmPlacement, BesideARangeImageItBeginsWhereTheImageShowsSomething) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    const simulation::BuiltWorld world = world_of("L", 1, "from one side");
    ASSERT_FALSE(world.image.empty());
    expect_good(kinematics::arm(), world, options_for(0.2, seed));
  }
}

/// Without the mesh, the links keep off the points and off the faces that are known beforehand.
TEST(ArmPlacement, BesidePointsAloneItKeepsOffWhatIsKnown) {
  const simulation::BuiltWorld whole = world_of("cube", 1, "from one side");
  PlacementOptions options = options_for(0.2, 1);
  options.start = simulation::random_start(whole, options.follow_distance, 1);
  simulation::BuiltWorld points = world_of("cube", 1, "from one side");
  points.truth.reset();
  const ArmPlacement placement = place_beside(kinematics::arm(), points, options);
  const Posture posture(placement.robot, placement.start);
  EXPECT_TRUE(posture.control_point().isApprox(*options.start, 1e-3));
  EXPECT_TRUE(feels(posture, *points.world));
  const double between_points = 1.0 / 80;
  EXPECT_GE(link_distance(posture, evaluation::TrueSurface(*whole.truth), options.spared),
            options.link_distance - between_points);
  options.start.reset();
  EXPECT_THROW(place_beside(kinematics::arm(), points, options), simulation::MeshError) << "no random start";
}

/// A posture that is good already is the one that is taken.
TEST(ArmPlacement, ThePostureThatIsAskedForIsTriedFirst) {
  const simulation::BuiltWorld world = world_of("cube", 1);
  int found_at_once = 0;  // at the first place for the base, which the seed alone decides
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    PlacementOptions options = options_for(0.2, seed);
    const ArmPlacement one = place_beside(kinematics::arm(), world, options);
    options.start = Posture(one.robot, one.start).control_point();
    options.posture = one.start;
    const ArmPlacement again = place_beside(kinematics::arm(), world, options);
    if (again.robot.links[0].mounting.matrix() != one.robot.links[0].mounting.matrix()) continue;
    ++found_at_once;
    EXPECT_EQ(again.start, one.start);
  }
  EXPECT_GT(found_at_once, 0);
}

TEST(ArmPlacement, AnObjectThatIsTooLargeIsToBeScaled) {
  const double reach = reach_of(kinematics::arm());
  EXPECT_GT(reach, 2.7);
  EXPECT_LE(reach, 3 + 1e-9) << "three links of 1";
  try {
    place_beside(kinematics::arm(), world_of("cube", 60), options_for(0.2, 1));
    FAIL() << "the cube is twenty times as large as the arm's reach";
  } catch (const simulation::MeshError& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("measures 60 x 60 x 60"), std::string::npos) << what;
    EXPECT_NE(what.find("scale it by about 0.01"), std::string::npos) << what;
  }
}

/// A flange whose shape goes round the control point is always nearer to a surface than it may be.
TEST(ArmPlacement, AControlPointWithinALinkIsToBePutFartherOut) {
  kinematics::Robot arm = kinematics::arm();
  kinematics::Link flange;
  flange.name = "flange";
  flange.parent = arm.control_point.link;
  flange.mounting.translation() = arm.control_point.position;
  flange.body = {{Vector3d::Zero(), Vector3d::Zero(), 0.15}};
  arm.links.push_back(flange);
  try {
    place_beside(arm, world_of("cube", 1), options_for(0.2, 1));
    FAIL() << "the flange is as large as the follow distance";
  } catch (const simulation::MeshError& error) {
    EXPECT_NE(std::string(error.what()).find("link 'flange': put it farther out by [control_point]"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace limpet::app
