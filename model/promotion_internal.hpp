// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <memory>
#include <vector>

#include "complex_internal.hpp"

/// Promotion: when a point segment becomes a planar polygon segment, and its first perimeter.
namespace limpet::model::internal {

/// Is the normal known well enough for a polygon? `raw`: all the points of fit and sums; if some are no
/// longer kept, rule `chance` does not try the fit with points left out.
bool promotable(const Complex&, const Fit&, const SegmentData::Sums&,
                const std::vector<const std::vector<RawPoint>*>& raw);
/// Have far fewer points come to a segment since its points came than to the rest of the scene (rule
/// `arrival`)? A true surface would have got about as many points per λ² as the surface modelled so far. In a
/// long stream, outliers and the tails of the noise form planes, too, but slowly. `since_sum`:
/// SegmentData::Sums::since.
bool too_few_arrived(const Complex&, const Fit&, double since_sum);
/// The same for a point segment, which would stand for about λ² of surface.
bool points_came_too_slowly(const Complex&, const Segment& point_segment);
/// A new polygon with its chart and the diamond (thesis §2.4.1) as perimeter; null when that is too small for
/// the grid.
std::unique_ptr<PolygonPart> diamond_part(Complex&, const Fit&);
/// Makes a point segment a polygon, and extends its diamond to the points that the segment keeps.
void promote(Complex&, const Segment&, std::unique_ptr<PolygonPart>);

}  // namespace limpet::model::internal
