// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/geometry/gap.hpp>
#include <limpet/geometry/polygon.hpp>

namespace limpet::geometry {

/// Connects two polygons of one chart that do not overlap (thesis §2.4.3): a section P of one perimeter is
/// extended to a section Q of the other, by two new edges between their ends, and what lies between is
/// filled.
///  - The ends of P are vertices, or points where an edge gets farther from Q than `gap` (λ, grid steps);
///    those of Q are the points nearest to them.
///  - Every vertex of P is within `gap` of the other perimeter, and the same holds for Q.
///  - P and Q contain the nearest pair of perimeter points or, where that pair allows no sections, a pair
///    that is locally nearest (the thesis tries no others, to save work).
///  - The new edges are lines of sight with respect to both perimeters.
///  - P is as long as possible.
/// Two outer perimeters are joined, or the outer one of one polygon and a hole of the other in which it lies.
/// With the result true `b` has become part of `a`, its surviving edges with their identities; otherwise
/// there was no valid candidate.
///  (1) When true, `a` is valid; when false, it is as it was;
///  (2) area of either is lost only to the rounding of new vertices, at most two steps along the perimeters;
///  (3) what is added lies within `gap` of one of them, up to rounding.
bool bridge_polygons(Polygon& a, const Polygon& b, const Gap& gap, EdgeIds&);

/// Connects a section of a perimeter at `vertex` with another section of the same perimeter that is within
/// `gap` and in sight across the outside. That splits the cycle in two, one of which becomes a hole. Sections
/// that are near each other along the perimeter are left to fill_fissures().
///  (1) When true, the polygon is valid and has one hole more; when false, it is as it was;
///  (2) shared edges stay.
bool bridge_self(Polygon&, Slot vertex, double gap, EdgeIds&);

}  // namespace limpet::geometry
