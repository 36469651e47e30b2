// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/geometry/gap.hpp>
#include <limpet/geometry/polygon.hpp>

namespace limpet::geometry {

/// Makes `a` the union of two overlapping polygons of one chart (thesis §2.4.3, "Merging Overlapping Planar
/// Polygons"), by a planar arrangement of b's edges and of the edges of a within b's bounding box. Every edge
/// of the arrangement knows its source edges, so that edges that survive whole keep their identities.
/// Crossings, collinear overlaps, touching vertices, and one polygon inside the other are all decided
/// exactly. Holes that are formed are dropped when they collapse (fissure.hpp) at `gap` (λ, grid steps); a
/// hole that reaches beyond b's bounding box is left to fill_fissures().
///
/// Where the union is thinner than a step (b touches a, or crosses a part of a that is so thin), it is made a
/// few steps wide. The candidate's vertices are rounded, and then it is judged. If rounding or a touching
/// vertex has broken it, the union is computed again with b's vertices moved a little, a bounded number of
/// times (`attempts` returns how many there were). Moves are at most 48 grid steps along each axis: less than
/// λ/42, and far below the accuracy of a perimeter. False when no candidate is valid.
///  (1) When true, `a` is valid; when false, it is as it was;
///  (2) the union contains both, up to rounding: 3 steps at the first attempt, and at later ones the moves of
///      b's vertices in addition;
///  (3) no area is lost except along the perimeters, within the same distance;
///  (4) a polygon united with itself stays as it is, vertices and identities;
///  (5) if both a ∪ b and b ∪ a are found, their areas differ by rounding and moves only. One may be found
///      without the other, because only b's vertices are moved, by amounts that depend on b's identities;
///  (6) what is in the union but in neither polygon (holes that collapsed) is within `gap` of one of them, up
///      to the same distance.
bool unite(Polygon& a, const Polygon& b, const Gap& gap, EdgeIds&, std::size_t* attempts = nullptr);

}  // namespace limpet::geometry
