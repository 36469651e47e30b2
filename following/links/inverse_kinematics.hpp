// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/following/links/task.hpp>
#include <optional>

namespace limpet::following {

/// The configuration to which a robot comes from `from`, when it is led on by the damped inverse of the
/// Jacobian until `task` has less than `precision` to go; joints stay within their limits. None: it does not
/// get there in a bounded number of steps. What is in the way is not looked at.
std::optional<kinematics::Configuration> led_to(const kinematics::Robot&, kinematics::Configuration from,
                                                const TaskIn& task, double precision);

}  // namespace limpet::following
