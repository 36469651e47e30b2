// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <limpet/kinematics/posture.hpp>

namespace limpet::following {

/// A point of a robot that is to be brought somewhere, in one posture: the way that it is to go (world,
/// scan's unit), and how it moves with each joint (3 × joint_count()).
struct Task {
  Eigen::Vector3d way;
  Eigen::Matrix3Xd jacobian;
};

/// The same in any posture, as the point gets there.
using TaskIn = std::function<Task(const kinematics::Posture&)>;

/// Of the control point.
inline Task control_point_task(const kinematics::Posture& posture, const Eigen::Vector3d& way) {
  return {way, posture.jacobian()};
}

}  // namespace limpet::following
