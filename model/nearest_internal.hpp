// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/model/view.hpp>

#include "complex_internal.hpp"

/// What one segment answers to questions about places, on its own. All the same whatever `limit` is, but for
/// whether there is an answer. `rounding` is rounding_near() what is asked about.
namespace limpet::model::internal {

// nearest.cpp
/// The point of the segment nearest to p, if it is within `limit`.
std::optional<View::Nearest> nearest_of(const Segment&, const Eigen::Vector3d& p, double limit,
                                        double rounding);

// nearest_to_link.cpp
/// The point of the segment nearest to the axis, if it is within `limit` of it; the distance is from the
/// axis.
std::optional<View::LinkNearest> nearest_of(const Segment&, const Capsule&, double limit, double rounding);

}  // namespace limpet::model::internal
