// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/geometry/search.hpp>

#include "segment_internal.hpp"
#include "setting_internal.hpp"

namespace limpet::model::internal {

/// How data centred at a point relates to a polygon segment.
struct Standing {
  bool near = false;                 ///< within λ, sensed from the right side, and fitting the plane
  double distance2 = 0;              ///< squared distance from the polygon, scan's unit
  bool outside = false;              ///< outside the perimeter, in the chart
  geometry::PerimeterPoint nearest;  ///< in the chart; when outside and `near`
  double gap = 0;                    ///< λ there, grid steps
  geometry::Point2 chart_point;
};
/// The standing of data centred at p (world), given the sum of its sensing axes, its mean squared residual
/// about the segment's plane, and the mean variance of its points.
Standing standing(const Setting&, const Segment& polygon, const Eigen::Vector3d& p,
                  const Eigen::Vector3d& axis, double squared_residual, double variance);
/// The largest mean squared residual about the segment's plane with which data of this variance, centred at
/// p, fits.
double residual_limit(const Setting&, const Segment& polygon, const Eigen::Vector3d& p, double variance);
/// Does a point fit a polygon near it?
bool fits(const Setting&, const RawPoint&, const Segment& polygon);
/// Does a reading at p (world) with this sensing axis and variance lie on an initial segment? It does when it
/// was sensed from outside, its projection is not outside the perimeter, and its height is what a mature
/// polygon's point may have: within the tolerance or three standard deviations, and less than λ.
bool lies_on_initial(const Setting&, const Segment& initial, const Eigen::Vector3d& p,
                     const Eigen::Vector3d& axis, double variance);

}  // namespace limpet::model::internal
