// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>

namespace limpet::following {

/// The closest surface model point, as the control point sees it.
struct ClosestPoint {
  double distance = 0;                              ///< from the control point, scan's unit; ≥ 0
  Eigen::Vector3d away = Eigen::Vector3d::UnitZ();  ///< unit vector from it towards the control point
};

/// The control point's motion (thesis §3.2, Figure 27), world frame, scan's unit: the sum of a corrective
/// motion, which restores the desired distance δ from the closest surface model point, and a perpendicular
/// motion along `along`, the surface following direction (any length; none when it is zero).
///  (1) it is no longer than σ = min(step, distance): it cannot lead into the closest surface model point;
///  (2) its part along `away` is δ − distance, cut off at ±σ;
///  (3) its length is σ, if `along` has a part perpendicular to `away`.
/// Preconditions: step ≥ 0, δ > 0.
Eigen::Vector3d control_point_motion(const ClosestPoint& closest, double follow_distance, double step,
                                     const Eigen::Vector3d& along);

}  // namespace limpet::following
