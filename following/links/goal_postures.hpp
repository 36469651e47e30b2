// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/following/links/link_motion.hpp>
#include <limpet/following/links/roadmap.hpp>
#include <span>
#include <vector>

namespace limpet::following {

// Where a robot is to go: configurations that are clear by what is known (LinkGuard::is_clear()), found from
// nodes of the roadmap and from configurations spread over the joints' ranges by the damped inverse of the
// Jacobian, and where that leads to none that is clear by steps of the programme, which keep links off
// (LinkMotion::led_clear()). Those that lie in sensed space come first, then by how near they are to the
// roadmap. Few: at most 4; empty when none is found. The same calls give the same answer.

/// With the control point at a place (world), to a tenth of λ.
std::vector<kinematics::Configuration> goal_postures(LinkMotion&, const Roadmap&,
                                                     const Eigen::Vector3d& place);

/// A place where surface is suspected (world).
struct Suspicion {
  Eigen::Vector3d at;
  Eigen::Vector3d normal;  ///< the way that surface would face; a unit vector
};

/// How well a place is to be seen.
enum class Sight {
  sure,  ///< at 75° of incidence or less, 0.7 λ within the range: the ray tells whether anything is there
  faint  ///< at 84° or less, at the end of the range: what is there may be met
};

/// With one of these sensors looking at the place: its axis goes through it to a tenth of λ, and nothing of
/// the model is between.
std::vector<kinematics::Configuration> sighting_postures(LinkMotion&, const Roadmap&, const Suspicion&, Sight,
                                                         std::span<const std::size_t> sensors);

/// A configuration within the joints' ranges, those without limits from −π to π, by the numbers from 0 to 1.
kinematics::Configuration spread_over(const kinematics::Robot&, const Eigen::VectorXd& unit);

}  // namespace limpet::following
