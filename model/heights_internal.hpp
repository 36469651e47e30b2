// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <optional>

#include "segment_internal.hpp"
#include "setting_internal.hpp"

/// The height maps of polygons (rule `relief`): kept only where Setting::relief_kept(); else these functions
/// do nothing.
namespace limpet::model::internal {

/// Adds `count` points at p (world).
void add_height(const Setting&, PolygonPart&, const Eigen::Vector3d& p, double count);
/// Adds another segment's points, as far as it keeps them or their heights.
void add_heights(const Setting&, PolygonPart&, const Segment& other);
/// Moves the height map to the polygon's new chart, from its old one.
void rechart_heights(const Setting&, PolygonPart&, const geometry::Chart& from);

/// A point's height over the surface near it, the variance of that surface's height, and the square of how
/// far the surface may have bent between there and the point. Scan's unit.
struct LocalResidual {
  double height = 0, variance = 0, bend2 = 0;
};
/// Nothing where the height map knows no height near p.
std::optional<LocalResidual> local_residual(const Setting&, const Segment& polygon, const Eigen::Vector3d& p);
/// Does the small segment continue the surface of the large one, judged where the heights of both are known?
bool surfaces_continue(const Setting&, const Segment& large, const Segment& small);

}  // namespace limpet::model::internal
