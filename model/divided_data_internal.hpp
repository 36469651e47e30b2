// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <optional>

#include "segment_internal.hpp"
#include "setting_internal.hpp"

namespace limpet::model::internal {

/// What a polygon that is cut in two leaves each of its parts.
struct Portion {
  SegmentData data;
  Fit fit;
  HeightMap heights;
};
struct Portions {
  Portion rest, piece;
};

/// Divides the data of a mature polygon between two parts of its perimeter, in its chart. Its readings are
/// gone: each part gets as many of them as its area asks for, spread evenly over it, as far from the plane of
/// best fit as they are on the whole. The counts add up to the whole's. Nothing if a part would get fewer
/// than kFewestOfPart.
std::optional<Portions> divided(const Setting&, const Segment&, const geometry::Polygon& rest,
                                const geometry::Polygon& piece);

}  // namespace limpet::model::internal
