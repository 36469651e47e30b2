// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <optional>

#include "segment_internal.hpp"
#include "setting_internal.hpp"

/// The height maps of polygons (rule `relief`): kept where Setting::relief_kept(), else nothing is done.
namespace limpet::model::internal {

/// So many points at p.
void add_height(const Setting&, PolygonPart&, const Eigen::Vector3d& p, double count);
/// All that is known of another segment's points.
void add_heights(const Setting&, PolygonPart&, const Segment& other);
/// After the chart has changed.
void rechart_heights(const Setting&, PolygonPart&, const geometry::Chart& from);

/// A point's height over the surface near it, the variance of the surface's height, and the square of what it
/// may have bent on the way. Nothing where no height is known.
struct LocalResidual {
  double height = 0, variance = 0, bend2 = 0;
};
std::optional<LocalResidual> local_residual(const Setting&, const Segment& polygon, const Eigen::Vector3d& p);
/// Does the small one go on from the large one where both are known?
bool surfaces_continue(const Setting&, const Segment& large, const Segment& small);

}  // namespace limpet::model::internal
