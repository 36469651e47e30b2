// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <memory>
#include <vector>

#include "complex_internal.hpp"

/// When is a segment a polygon? The rule that makes a point segment a planar polygon segment, and its first
/// perimeter.
namespace limpet::model::internal {

/// Is the normal known well enough to be a polygon's? `raw` are all the points behind fit and sums, or none.
bool promotable(const Complex&, const Fit&, const SegmentData::Sums&,
                const std::vector<const std::vector<RawPoint>*>& raw);
/// Have far fewer points come to it, while they waited, than to the rest of the scene? Had this been a
/// surface all that time, about as many would have come to each λ² of it as to any λ² of the surface that is
/// known. Where a stream is long, outliers, and readings far out in the tails of the noise, make planes, too,
/// but they take their time.
bool too_few_arrived(const Complex&, const Fit&, double since_sum);
/// The same of a point segment, which stands for about λ² of surface if it is any.
bool points_came_too_slowly(const Complex&, const Segment& point_segment);
/// Chart and diamond (thesis §2.4.1); nothing when that is too small for the grid.
std::unique_ptr<PolygonPart> diamond_part(Complex&, const Fit&);
/// Makes a point segment a polygon, of which the diamond is extended to the points it keeps.
void promote(Complex&, const Segment&, std::unique_ptr<PolygonPart>);

}  // namespace limpet::model::internal
