// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/following/links/link_motion.hpp>
#include <limpet/following/links/roadmap.hpp>
#include <vector>

namespace limpet::following {

/// Clear configurations (LinkGuard::is_clear()) with the control point at a place (world), to a tenth of λ:
/// found by the damped inverse of the Jacobian from configurations of the roadmap, nearest place first, and
/// from others spread over the joints' ranges. Those that lie in sensed space come first, then by how near
/// they are to the roadmap. Few: at most 6; empty when none is found. The same calls give the same answer.
std::vector<kinematics::Configuration> goal_postures(const LinkMotion&, const Roadmap&,
                                                     const Eigen::Vector3d& place);

/// A configuration within the joints' ranges, those without limits from −π to π, by the numbers from 0 to 1.
kinematics::Configuration spread_over(const kinematics::Robot&, const Eigen::VectorXd& unit);

/// Do all links lie in space that was seen to be free?
bool lies_in_sensed(const LinkMotion&, const kinematics::Posture&);

}  // namespace limpet::following
