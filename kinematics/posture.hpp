// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include <limpet/kinematics/robot.hpp>
#include <limpet/model/sensor_point.hpp>

namespace limpet::kinematics {

/// The positions of the joints that move: lengths and radians.
using Configuration = Eigen::VectorXd;

/// A robot in a configuration: forward kinematics. The robot must outlive it.
class Posture {
 public:
  /// Throws std::invalid_argument unless there is one finite position for each joint that moves. Joint limits
  /// are not checked.
  Posture(const Robot&, const Configuration&);

  const Robot& robot() const { return *robot_; }
  const Configuration& configuration() const { return configuration_; }
  /// Pose of a link's frame in the world.
  const Eigen::Isometry3d& link(std::size_t i) const { return links_[i]; }
  /// x: the control point's position in the world.
  Eigen::Vector3d control_point() const;

  /// A sensor in the world.
  struct Sensor {
    Eigen::Vector3d position, axis;
    double range = 0;
  };
  Sensor sensor(std::size_t i) const;

  /// A proximity switch in the world.
  struct Switch {
    Eigen::Vector3d position, axis;
    Eigen::Vector3d field_centre;
    double range = 0;
  };
  Switch proximity_switch(std::size_t i) const;

  /// The sensor point of a reading at this distance: p = s + d·a (thesis (1)).
  model::SensorPoint sensor_point(std::size_t sensor, double distance) const;

  /// J of thesis (2): how the control point moves with each joint, 3 × joint_count().
  Eigen::Matrix3Xd jacobian() const;
  /// The same for any point fixed to a link, given where it is in the world. Its columns are the r_ik of
  /// thesis (5); those of joints that do not carry the link are 0.
  Eigen::Matrix3Xd jacobian(std::size_t link, const Eigen::Vector3d& point_world) const;

 private:
  const Robot* robot_;
  Configuration configuration_;
  std::vector<Eigen::Isometry3d> links_;
};

/// The smallest actuator changes that move the control point by `motion` (world, scan's unit), as the
/// Jacobian has it (thesis §3.2: Θ̇ = G ẋ, G the pseudo-inverse), or as near to that as any changes do; then
/// limited(). Empty for a robot without joints.
Configuration actuator_changes(const Posture&, const Eigen::Vector3d& motion);

/// Lengths of changes of the actuators, as the ceilings bound them.
struct LengthsByKind {
  double prismatic = 0, revolute_rad = 0;
};

/// The lengths of the vectors of all changes of prismatic joints, and of all those of revolute ones, one
/// change for each joint that moves.
LengthsByKind lengths_by_kind(const Robot&, const Eigen::VectorXd& changes);

/// The nearest configuration that keeps the limits of all joints.
Configuration within_limits(const Robot&, Configuration);

/// The changes scaled down, all by the same factor, until both ceilings and the joints' limits are kept.
Configuration limited(const Posture&, const Configuration& changes);

}  // namespace limpet::kinematics
