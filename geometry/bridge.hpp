// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/geometry/polygon.hpp>

namespace limpet::geometry {

/// Connects two polygons of one chart that do not overlap (thesis §2.4.3): a section P of one perimeter is
/// extended to a section Q of the other. The ends of P are vertices (or points where the next edge leaves
/// the gap), those of Q the points nearest to them;
/// every vertex of P is within `gap` (λ, grid steps) of Q's perimeter and the reverse; P and Q hold the
/// nearest pair of perimeter points (where that pair allows no sections, a locally nearest one, which the
/// thesis leaves out to save work); the new edges are lines of sight relative to both perimeters; P is as
/// long as possible. Outer perimeters, or the outer one of one polygon and a hole of the other that it lies
/// in, are joined alike. `b` becomes part of `a` (its surviving edges keep their identities), or `a` is left
/// as it was and the result is false.
///  (1) When true, `a` is valid; when false, it is as it was;
///  (2) no area is lost of either but to the rounding of feet, at most two steps along the perimeters;
///  (3) what is added lies within `gap` of one of them, but for rounding.
bool bridge_polygons(Polygon& a, const Polygon& b, double gap, EdgeIds&);

/// Connects the perimeter at `vertex` with another section of the same perimeter within `gap` and in sight
/// across the outside, which splits the cycle: a hole appears. Sections adjacent along the perimeter are left
/// to fissures.
///  (1) When true, the polygon is valid with one hole more; when false, it is as it was;
///  (2) shared edges stay.
bool bridge_self(Polygon&, Slot vertex, double gap, EdgeIds&);

}  // namespace limpet::geometry
