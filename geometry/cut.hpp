// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <optional>
#include <vector>

#include <limpet/geometry/polygon.hpp>

namespace limpet::geometry {

/// What cutting a polygon in two would make of it.
struct Cut {
  Edit rest;          ///< takes the piece away from the polygon
  Polygon piece;      ///< of the same coordinates, with the holes that lie in it; all its edges are new
  double length = 0;  ///< of the way through the inside, grid steps
};

/// Cuts a polygon along the segment from a to b, which begins and ends outside it and passes once through
/// its inside, between two edges of one cycle. Both parts get the two places where these edges are crossed,
/// rounded, as vertices. The smaller part is the piece. Nothing if the segment does not run like that,
/// touches a vertex, or a part would not be valid.
///  (1) Both parts are valid, and on different sides of the segment where it passes through;
///  (2) their areas add up to the polygon's, up to the rounding of the two places;
///  (3) every vertex of the polygon that the cut is not rounded to is a vertex of just one of them, every
///      hole that is not cut a hole of one.
std::optional<Cut> cut_off(const Polygon&, Point2 a, Point2 b, EdgeIds&);

}  // namespace limpet::geometry
