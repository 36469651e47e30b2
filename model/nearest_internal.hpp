// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/model/view.hpp>

#include "complex_internal.hpp"

/// The nearest point of a single segment. `limit` decides only whether there is a result, not what it is.
/// `rounding` is rounding_near() the point or link.
namespace limpet::model::internal {

// nearest.cpp
/// The point of the segment nearest to p, if it is within `limit`.
std::optional<View::Nearest> nearest_of(const Segment&, const Eigen::Vector3d& p, double limit,
                                        double rounding);

// nearest_to_link.cpp
/// The point of the segment nearest to the link's axis, if it is within `limit` of the axis. The distance is
/// from the axis, not from the surface.
std::optional<View::LinkNearest> nearest_of(const Segment&, const Capsule&, double limit, double rounding);

}  // namespace limpet::model::internal
