// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <limpet/evaluation/arm_reachable.hpp>
#include <limpet/kinematics/arm.hpp>
#include <limpet/simulation/box_world.hpp>
#include <memory>
#include <numbers>
#include <vector>

/// Arms beside objects, with λ 0.1 and the thesis's multiples of it.
namespace limpet::evaluation::testing {

inline constexpr double kArmResolution = 0.1, kArmRange = 0.4;

/// Two links of length 1 and radius 0.02 from the origin, which turn about z; one sensor at the end of the
/// second, that looks along it.
inline kinematics::Robot planar_arm() {
  kinematics::Robot robot;
  for (std::size_t i = 0; i < 2; ++i) {
    kinematics::Link link;
    if (i > 0) {
      link.parent = i - 1;
      link.mounting.translation() = Eigen::Vector3d::UnitX();
    }
    link.joint = {kinematics::Joint::Kind::revolute, Eigen::Vector3d::UnitZ()};
    link.body = {{Eigen::Vector3d::Zero(), Eigen::Vector3d(i > 0 ? 0.95 : 1, 0, 0), 0.02}};
    robot.links.push_back(link);
  }
  robot.control_point = {1, Eigen::Vector3d::UnitX()};
  robot.sensors = {{1, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitX(), kArmRange}};
  return robot;
}

inline kinematics::Configuration joints(std::initializer_list<double> positions) {
  kinematics::Configuration at(static_cast<Eigen::Index>(positions.size()));
  std::copy(positions.begin(), positions.end(), at.data());
  return at;
}

/// The thesis's arm, links of length 2, its base at a place, folded back: its end is near the base.
inline PlacedArm thesis_arm_at(const Eigen::Vector3d& base) {
  const kinematics::Robot robot = kinematics::arm(kinematics::scaled({}, 2));
  return {kinematics::placed(robot, Eigen::Isometry3d(Eigen::Translation3d(base))),
          joints({0, -0.5, 0, -1, 0, -1}),
          {}};
}

/// A mesh, an arm beside it, and what the arm can feel.
struct ArmWorld {
  simulation::Mesh mesh;
  PlacedArm arm;
  std::unique_ptr<TrueSurface> truth;
  std::unique_ptr<ArmReach> reach;

  ArmWorld(simulation::Mesh object, PlacedArm placed, std::uint64_t seed = 1)
      : mesh(std::move(object)), arm(std::move(placed)), truth(std::make_unique<TrueSurface>(mesh)) {
    ArmSearchOptions options;
    options.resolution = options.control_clearance = kArmResolution;
    options.seed = seed;
    reach = std::make_unique<ArmReach>(mesh, *truth, arm, options);
  }

  ArmReachability look(std::size_t count) {
    auto [samples, spacing] = about(count, mesh);
    return reach->of(std::move(samples), spacing);
  }
  Verdict verdict(const Eigen::Vector3d& at, const Eigen::Vector3d& normal) {
    return reach->of({{at, normal, 0, 1}}, kArmResolution).reachability.verdicts.front();
  }
};

/// How much room an arm has in a configuration, at places close together along its links: the least of what
/// is above the clearances, of the control point and of links from the surface.
inline double room_of(const ArmWorld& world, const kinematics::Configuration& at) {
  const kinematics::Robot& robot = world.arm.robot;
  const kinematics::Posture posture(robot, at);
  double room = world.truth->distance(posture.control_point()) - kArmResolution;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (!robot.links[i].parent && robot.links[i].joint.kind == kinematics::Joint::Kind::fixed) continue;
    for (const model::Capsule& part : robot.links[i].body)
      for (int k = 0; k <= 40; ++k) {
        const Eigen::Vector3d place = posture.link(i) * (part.a + k / 40.0 * (part.b - part.a));
        room = std::min(room, world.truth->distance(place) - part.radius - kArmResolution / 10);
      }
  }
  return room;
}

/// The least room on a way, at places on it close together.
inline double room_along(const ArmWorld& world, const std::vector<kinematics::Configuration>& way,
                         int pieces) {
  double room = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < way.size(); ++i)
    for (int k = 0; k <= pieces; ++k)
      room = std::min(room, room_of(world, way[i] + static_cast<double>(k) / pieces * (way[i + 1] - way[i])));
  return room;
}

/// Two configurations that are the same place of every joint, perhaps whole turns apart.
inline bool are_same_place(const kinematics::Configuration& one, const kinematics::Configuration& other) {
  constexpr double kTurn = 2 * std::numbers::pi;
  return ((one - other) / kTurn - ((one - other) / kTurn).array().round().matrix()).norm() < 1e-9;
}

}  // namespace limpet::evaluation::testing
