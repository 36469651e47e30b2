// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include "complex_internal.hpp"
#include "pending_points_internal.hpp"
#include "standing_internal.hpp"

/// Merging segments (thesis §2.4). Where a merger is refused, the segments are unchanged, unless said
/// otherwise.
namespace limpet::model::internal {

/// §2.4.1: merges two point segments into `into`, which becomes a polygon if the rules allow it.
enum class PointMerger { refused, point, polygon };
PointMerger merge_point_segments(Complex&, Agenda&, PendingPoints& pending, const Segment& into,
                                 const Segment& from);
/// At a few points per λ², point segments end up about λ apart, each with too few points to determine a
/// normal. This merges a point segment with young ones around it that lie in one plane with it, if together
/// they determine the normal (rule `patch`). Returns whether the seed has become a polygon.
bool promote_patch(Complex&, Agenda&, PendingPoints& pending, const Segment& seed);

/// §2.4.2: merges a point, or a point segment, into a polygon segment. Returns whether it was accepted.
bool merge_point_into_polygon(Complex&, Agenda&, const Segment& polygon, const RawPoint&, const Standing&);
bool merge_segment_into_polygon(Complex&, Agenda&, const Segment& polygon, const Segment& point_segment,
                                const Standing&);

/// §2.4.3: tries to merge `other` with a polygon that has changed. Even if it is refused, the two may be
/// neighbours no more, because the edges they share are dissolved before their perimeters are tried. Returns
/// whether they merged.
bool merge_polygon_segments(Complex&, Agenda&, const Segment& changed, const Segment& other);
/// Step 2a for polygons. Returns whether any merged.
bool merge_modified_polygons(Complex&, Agenda&);

}  // namespace limpet::model::internal
