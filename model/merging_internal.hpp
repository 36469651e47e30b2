// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include "complex_internal.hpp"
#include "insertion_internal.hpp"
#include "standing_internal.hpp"

/// Merging segments (thesis §2.4). Where it is refused, nothing of the segments has changed, but for what is
/// said.
namespace limpet::model::internal {

/// §2.4.1: two point segments become `into`; or, where they have become a polygon, that.
enum class PointMerger { refused, point, polygon };
PointMerger merge_point_segments(Complex&, Agenda&, PendingPoints& pending, const Segment& into,
                                 const Segment& from);
/// At a few points per λ², point segments settle about λ apart with too few points each for a normal: a point
/// segment and the young ones around it that lie in one plane with it may know it together. Whether the seed
/// is a polygon now.
bool promote_patch(Complex&, Agenda&, PendingPoints& pending, const Segment& seed);

/// §2.4.2: a point, or a point segment, becomes part of a polygon segment.
bool merge_point_into_polygon(Complex&, Agenda&, const Segment& polygon, const RawPoint&, const Standing&);
bool merge_segment_into_polygon(Complex&, Agenda&, const Segment& polygon, const Segment& point_segment,
                                const Standing&);

/// §2.4.3: tries to merge `other` with a polygon that has changed. Refused late, it may have left the two no
/// neighbours: shared edges between the two are dissolved before perimeters are tried.
bool merge_polygon_segments(Complex&, Agenda&, const Segment& changed, const Segment& other);
/// Step 2a for polygons; returns whether any merger succeeded.
bool merge_modified_polygons(Complex&, Agenda&);

/// Does `other` come within the gap of `s`, or lie inside or around it, where s has changed? Never false when
/// a merger could succeed there.
bool may_meet_where_changed(const Setting&, const Segment& s, const DirtyRegion& changed,
                            const Segment& other);
/// Is p within λ of the polygon?
bool lies_near(const Setting&, const PolygonPart&, const Eigen::Vector3d& p);

}  // namespace limpet::model::internal
