// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <span>

#include <limpet/geometry/polygon.hpp>

namespace limpet::geometry {

/// Fills the fissures that edges in `fresh` take part in, and those that filling forms (thesis §2.5): at each
/// set of consecutive vertices types IV, V, VI, I, II, III in this order, and, since a perimeter that grew
/// around something meets itself, bridges sections of one perimeter that are within `gap` and in sight of
/// each other (thesis §2.3, "between two points on the same model segment"), unless `bridge` is false. A hole
/// that collapses is dropped. `gap` is λ in grid steps. Returns how many were filled.
///  (1) The polygon stays valid, and as it was when none was filled;
///  (2) shared edges stay;
///  (3) area is lost to the rounding of feet only, never more than two steps along the perimeter
///      (the tip of a needle less than a step wide may go);
///  (4) what is added lies within `gap` of what was there, but for rounding.
/// Filling again may fill more, where what went has opened a line of sight.
std::size_t fill_fissures(Polygon&, std::span<const std::pair<Slot, EdgeId>> fresh, double gap, EdgeIds&,
                          bool bridge = true);

/// Does a closed chain vanish when its fissures are filled, shared edges and sight left aside (thesis §2.4.3,
/// §2.5)? Greedy: which vertex comes first may matter to a chain that only just collapses, and so may turns
/// (feet are rounded, ties up) and a wider gap.
bool collapses(std::vector<Point2> chain, double gap);

}  // namespace limpet::geometry
