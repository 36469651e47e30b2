// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Geometry>
#include <limpet/kinematics/posture.hpp>
#include <limpet/survey/random.hpp>
#include <numbers>
#include <string>

/// Robots at random.
namespace limpet::kinematics::testing {

inline constexpr double kRightAngle = std::numbers::pi / 2;

inline Eigen::Vector3d random_vector(survey::Random& random, double reach) {
  const double x = random.uniform(-reach, reach);
  const double y = random.uniform(-reach, reach);
  const double z = random.uniform(-reach, reach);
  return {x, y, z};
}

inline Eigen::Vector3d random_axis(survey::Random& random) {
  const double x = random.normal();
  const double y = random.normal();
  const double z = random.normal();
  return Eigen::Vector3d(x, y, z).normalized();
}

inline Eigen::Isometry3d random_pose(survey::Random& random) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = random_vector(random, 1);
  const Eigen::Vector3d axis = random_axis(random);
  pose.linear() = Eigen::AngleAxisd(random.uniform(-3, 3), axis).toRotationMatrix();
  return pose;
}

/// A tree of so many links with all three kinds of joints, its control point and some sensors on any of them.
inline Robot random_robot(survey::Random& random, std::size_t links) {
  Robot robot;
  for (std::size_t i = 0; i < links; ++i) {
    Link link;
    link.name = "link" + std::to_string(i);
    const std::size_t parent = random.below(i + 1);  // i stands for the world
    if (parent < i) link.parent = parent;
    link.mounting = random_pose(random);
    link.joint.kind = static_cast<Joint::Kind>(random.below(3));
    link.joint.axis = random_axis(random);
    robot.links.push_back(link);
  }
  robot.control_point = {random.below(links), random_vector(random, 1)};
  for (int i = 0; i < 5; ++i) {
    const std::size_t on = random.below(links);
    const Eigen::Vector3d position = random_vector(random, 1);
    robot.sensors.push_back({on, position, random_axis(random), 0.2});
  }
  return robot;
}

/// A chain of so many links that move, the control point on the last.
inline Robot random_chain(survey::Random& random, std::size_t links) {
  Robot robot = random_robot(random, links);
  for (std::size_t i = 0; i < links; ++i) {
    if (i > 0) robot.links[i].parent = i - 1;
    robot.links[i].joint.kind = random.below(3) == 0 ? Joint::Kind::prismatic : Joint::Kind::revolute;
  }
  robot.control_point.link = links - 1;
  return robot;
}

inline Configuration random_configuration(survey::Random& random, const Robot& robot) {
  Configuration configuration(static_cast<Eigen::Index>(robot.joint_count()));
  for (double& position : configuration) position = random.uniform(-2, 2);
  return configuration;
}

/// Links in a row, each one unit along the x axis of the one before, turning about z: an arm in the plane.
inline Robot planar_arm(int links) {
  Robot robot;
  for (int i = 0; i < links; ++i) {
    Link link;
    link.name = "link" + std::to_string(i);
    if (i > 0) {
      link.parent = static_cast<std::size_t>(i - 1);
      link.mounting.translation() = Eigen::Vector3d::UnitX();
    }
    link.joint = {Joint::Kind::revolute, Eigen::Vector3d::UnitZ()};
    robot.links.push_back(link);
  }
  robot.control_point = {static_cast<std::size_t>(links - 1), Eigen::Vector3d::UnitX()};
  return robot;
}

}  // namespace limpet::kinematics::testing
