// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <limpet/kinematics/posture.hpp>
#include <optional>

namespace limpet::following {

/// What is to be brought somewhere, in one posture: the way that it still has to go (world, scan's unit), and
/// how it moves with each joint (3 × joint_count()).
struct Task {
  Eigen::Vector3d way;
  Eigen::Matrix3Xd jacobian;
};

/// The configuration to which a robot comes from `from`, when it is led on by the damped inverse of the
/// Jacobian until `task` has less than `precision` to go; joints stay within their limits. None: it does not
/// get there in a bounded number of steps. What is in the way is not looked at.
std::optional<kinematics::Configuration> led_to(const kinematics::Robot&, kinematics::Configuration from,
                                                const std::function<Task(const kinematics::Posture&)>& task,
                                                double precision);

}  // namespace limpet::following
