// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include <limpet/geometry/chart.hpp>
#include "moments_internal.hpp"

namespace limpet::model {

/// Point and plane of best fit to the points that some moments are of (thesis §2.2): centroid, eigenvalues u1
/// ≥ u2 ≥ u3 of the covariance (scan's unit squared) and their axes. The normal is the axis of u3; fit_to()
/// chooses its sign.
struct Fit {
  // The members that every new point needs come first, within one cache line.
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double u2 = 0, count = 0;
  double u1 = 0, u3 = 0;
  Eigen::Vector3d axis1 = Eigen::Vector3d::UnitX(), axis2 = Eigen::Vector3d::UnitY();

  /// Variance about the point of best fit, s_pt² (thesis §2.2); the variance about the plane, s_pp², is u3.
  double point_variance() const { return u1 + u2 + u3; }
  geometry::Plane plane() const { return {centroid, normal}; }
  double height_of(const Eigen::Vector3d& p) const { return normal.dot(p - centroid); }
  /// Variance of the plane's height at p when each point has variance `variance` along the normal.
  double height_variance(const Eigen::Vector3d& p, double variance) const {
    const Eigen::Vector3d d = p - centroid;
    const double h = normal.dot(d);
    const double in_plane2 = std::max(0.0, d.dot(d) - h * h);
    return variance / count * (1 + in_plane2 / std::max(u2, 1e-300));
  }
  /// Standard error of the normal, in radians, when each point has variance `variance` along it.
  double normal_error(double variance) const;
};

/// The fit to some moments, with the normal turned away from `inside` (a sum of sensing axes, which point
/// into the surface; thesis §2.4.1). `step`: the grid step, scan's unit. Precondition: at least one point.
///  (1) u1 ≥ u2 ≥ u3 ≥ 0 and the axes are orthonormal (of two points or more);
///  (2) normal · inside ≤ 0; the opposite `inside` gives the opposite normal, unless they are at
///      right angles;
///  (3) when the points move and the covariance stays the same (Moments, law 2), only the centroid changes,
///      to the last bit.
Fit fit_to(const Moments&, double step, const Eigen::Vector3d& inside);

}  // namespace limpet::model
