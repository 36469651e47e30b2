// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include "segment_internal.hpp"
#include "setting_internal.hpp"

namespace limpet::model::internal {

/// How a point stands to a polygon segment; `distance2` is from the polygon, squared.
struct Standing {
  bool near = false;  ///< nearer than λ, on the right side, and fitting
  double distance2 = 0;
  bool outside = false;           ///< of the perimeter
  double perimeter_distance = 0;  ///< grid steps, when outside
  geometry::Point2 chart_point;
};
/// Of data centred at p, with the sum of its sensing axes, its mean squared residual about the segment's
/// plane, and the mean variance of its points.
Standing standing(const Setting&, const Segment& polygon, const Eigen::Vector3d& p,
                  const Eigen::Vector3d& axis, double squared_residual, double variance);
/// Largest squared residual that data of this variance centred at p may have about the segment's plane.
double residual_limit(const Setting&, const Segment& polygon, const Eigen::Vector3d& p, double variance);

}  // namespace limpet::model::internal
