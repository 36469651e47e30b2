// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/geometry/polygon.hpp>

namespace limpet::geometry {

/// Makes `a` the union of two overlapping polygons of one chart (thesis §2.4.3, "Merging Overlapping Planar
/// Polygons"), by a planar arrangement of b's edges and those of a in b's window, with the source edge of
/// every piece carried along: edges that survive whole keep their identities. Crossings, coincident
/// stretches, touching vertices, and one inside the other are all decided exactly. Holes formed are dropped
/// when they collapse at `gap` (λ, grid steps), else kept; what is left of a hole that reaches beyond b's
/// window is left to fill_fissures().
///
/// Where the union is thinner than a step (b touches a, or crosses a part of a that thin), it is made a few
/// steps wide. The candidate's vertices are rounded and then judged. Where rounding or a touching vertex
/// broke it, b's vertices are moved by a few grid steps (up to λ/43 and 48, far below what a perimeter is
/// known to) and the outline is taken again, a bounded number of times (`attempts` tells how often it was
/// taken). False, and `a` as it was, when no candidate is valid.
///  (1) When true, `a` is valid; when false, it is as it was;
///  (2) the union holds both but for rounding: 3 steps at the first attempt, and the moves of b's
///      vertices more at later ones;
///  (3) no area is lost but along the perimeters, by as much;
///  (4) what is united with itself stays as it is, vertices and identities;
///  (5) where both a ∪ b and b ∪ a are found, their areas differ by rounding and moves alone. The one
///      may be found without the other: only b's vertices are moved, by its identities;
///  (6) what lies in neither (holes that collapsed) is within `gap` of one of them, but for as much.
bool unite(Polygon& a, const Polygon& b, double gap, EdgeIds&, std::size_t* attempts = nullptr);

}  // namespace limpet::geometry
