// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limpet/kinematics/posture.hpp>
#include <span>
#include <vector>

namespace limpet::kinematics {

/// Redundant degrees of freedom keep the links away from the surface, as in thesis §3.3 and appendices A and
/// B.

/// A point of a link and the point of an obstacle that is nearest to it; world, scan's unit.
struct Proximity {
  std::size_t link = 0;
  Eigen::Vector3d on_link = Eigen::Vector3d::Zero();   ///< l_i
  Eigen::Vector3d obstacle = Eigen::Vector3d::Zero();  ///< s_i
  /// Unit vector from the obstacle to the link; where they meet, the way out.
  Eigen::Vector3d away = Eigen::Vector3d::UnitZ();
  double distance = 0;  ///< signed: negative where the obstacle is inside the link
};

struct RedundancyParameters {
  double gain = 7000;      ///< α
  int exponent = 6;        ///< g, ≥ 1
  double influence = 0.2;  ///< √(2 d₀): no link farther away than this matters; > 0
};

/// H of (4), Σ over the proximities: 0 when all are farther than the influence, at most d₀/g for each.
double objective(std::span<const Proximity>, const RedundancyParameters&);

/// z = −∇H of (5): one number for each joint that moves. What is given is the link's nearest point for each
/// link (the thesis), or more than one.
Eigen::VectorXd reconfiguration(const Posture&, std::span<const Proximity>, const RedundancyParameters&);

/// (3): Θ̇ = G ẋ + α (I − G J) z with G = J⁺, not yet limited(). The second term does not move the control
/// point.
Configuration redundant_changes(const Posture&, const Eigen::Vector3d& motion, const Eigen::VectorXd& z,
                                double gain);

/// z of appendix B: what the switches that see something are taken to see is at the centres of their fields,
/// with √(2 d₀) the range of each. Precondition: numbers of switches are below switches.size().
Eigen::VectorXd reconfiguration(const Posture&, std::span<const ProximitySwitch> switches,
                                std::span<const std::size_t> seeing, int exponent);

}  // namespace limpet::kinematics
