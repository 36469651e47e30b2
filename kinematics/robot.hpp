// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <limpet/model/view.hpp>

namespace limpet::kinematics {

/// How a link moves against its parent.
struct Joint {
  enum class Kind { fixed, prismatic, revolute };
  Kind kind = Kind::fixed;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< unit vector in the joint's frame
  /// Limits of the joint's position: lengths of a prismatic joint, radians of a revolute one.
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  /// The fastest it moves: lengths or radians a second. Runs, which have no times, do not record it.
  double max_velocity = std::numeric_limits<double>::infinity();
};

/// How a joint at this position moves its link in the joint's frame.
Eigen::Isometry3d motion_of(const Joint&, double position);

/// A rigid part of the robot. Its frame is its joint's frame, moved by the joint.
struct Link {
  std::string name;
  std::optional<std::size_t> parent;                           ///< an earlier link; none: the world
  Eigen::Isometry3d mounting = Eigen::Isometry3d::Identity();  ///< joint's frame in the parent's frame
  Joint joint;
  std::vector<model::Capsule> body;  ///< in the link's frame; empty: a link without extent
};

/// A single-point range finder, in the frame of the link that it is mounted on.
struct RangeSensor {
  std::size_t link = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< sensing axis, a unit vector
  double range = 0;                                 ///< sensing range: the largest distance it measures
};

/// A proximity switch (thesis appendix B), in the frame of its link: it says whether anything is in its
/// field, a ball whose diameter, from the switch along its axis, is the range. It says neither where nor how
/// far.
struct ProximitySwitch {
  std::size_t link = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< unit vector
  double range = 0;                                 ///< > 0, finite
  /// c: where what it sees is taken to be.
  Eigen::Vector3d field_centre() const { return position + range / 2 * axis; }
};

/// The point that is moved over the surface (thesis §1.2), in its link's frame.
struct ControlPoint {
  std::size_t link = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

/// The largest changes of the actuators in one step, γ (thesis §3.3): the length of the vector of changes of
/// all prismatic joints, and of all revolute ones.
struct Ceilings {
  double prismatic = std::numeric_limits<double>::infinity();
  double revolute_rad = std::numeric_limits<double>::infinity();

  /// That of the joint's kind. Precondition: the joint moves.
  double of(const Joint& joint) const {
    return joint.kind == Joint::Kind::prismatic ? prismatic : revolute_rad;
  }
};

/// A robot: a tree of links, each after its parent, with the sensors and switches mounted on them. The joints
/// that move are numbered as their links are ordered.
struct Robot {
  std::string name;
  std::vector<Link> links;
  ControlPoint control_point;
  std::vector<RangeSensor> sensors;
  std::vector<ProximitySwitch> switches;
  Ceilings ceilings;

  /// Number of joints that move.
  std::size_t joint_count() const;
};

/// Calls use(k, joint) with each joint that moves, and its number k, in their order. The joints of a robot
/// that is not const may be changed.
template <class AnyRobot, class Use>
void for_each_moving_joint(AnyRobot& robot, Use use) {
  Eigen::Index k = 0;
  for (auto& link : robot.links)
    if (link.joint.kind != Joint::Kind::fixed) use(k++, link.joint);
}

/// Throws std::invalid_argument, with one line that says what and where, when a link's parent does not come
/// before it, a mounting is not rigid, an axis is no unit vector, a position is not finite, a range, ceiling
/// or velocity is not positive, that of a switch not finite, a radius is negative, limits are out of order,
/// or a link of the control point, of a sensor or of a switch does not exist.
void require_sound(const Robot&);

/// The same robot, standing elsewhere: whatever the world carries is moved by `base`, rigidly, in the world.
Robot placed(Robot, const Eigen::Isometry3d& base);

/// The same robot with its links covered with proximity switches (thesis §3.3): each range sensor that is not
/// at the control point becomes a switch of its place, axis and range, after the switches there are. The
/// numbers of the sensors that are left follow their order. Precondition: their ranges are finite.
Robot with_switches(Robot);

/// What the mobile point robot of thesis §4.3 is made of.
struct PointRobotOptions {
  double sensing_range = 0.2;
  double ceiling = 0.05;  ///< γ: the longest step
  /// How the robot stands in the world: its sensing axes are those below, turned by this.
  Eigen::Quaterniond heading = Eigen::Quaterniond::Identity();
};

/// The mobile point robot (thesis §4.3): three orthogonal prismatic joints, the control point at its centre,
/// and 26 sensors there, whose axes are the directions from a cube's centre to its 6 faces, 12 edges and 8
/// corners, in this order. A configuration is the control point's position in the world. Precondition: the
/// heading is not zero. Throws std::invalid_argument when the range or the ceiling is not positive.
Robot point_robot(const PointRobotOptions&);

}  // namespace limpet::kinematics
