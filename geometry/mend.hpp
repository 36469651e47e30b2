// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <vector>

#include <limpet/geometry/polygon.hpp>

namespace limpet::geometry {

/// Repairs cycles that were transferred from one chart into another, where rounding may have carried a vertex
/// onto an edge or across it. Such a vertex is moved back to the side of the edge that it was on, by at most
/// two grid steps along each axis; nothing else changes. `before` are the same cycles, vertex by vertex, in
/// the chart in which they were valid; the two charts face the same way. False when edges are still in
/// conflict after a few rounds.
///  (1) When true, no edges are in conflict. When false, or when none were in conflict, the cycles are as
///      they were;
///  (2) no vertex moves farther than two steps along an axis, however many conflicts it takes part in.
bool restore_sides(std::vector<std::vector<NewVertex>>& cycles,
                   const std::vector<std::vector<NewVertex>>& before);

/// Repairs cycles (outer first) that rounding has broken. First, vertices closer than two grid steps to the
/// one before are removed. Then, as long as edges are in conflict, of the ends of two such edges the one
/// whose removal changes the least area is removed; thin spikes and necks vanish in this way. Edges that
/// change lose their identities, and holes may vanish. False when the outer cycle does not survive, or when
/// removals would change more than `area` (grid steps squared) in all. The result still has to be judged.
///  (1) When true, no edges are in conflict;
///  (2) cycles without conflicts and without such close vertices stay as they are. Mending twice may still
///      change more than mending once: a removal can leave two vertices close together;
///  (3) motions (predicates.hpp) keep the outcome, vertex for vertex;
///  (4) when true, the area has changed by at most `area`, not counting what was removed with close vertices;
///      for any larger `area` the result is then the same.
bool mend_cycles(std::vector<std::vector<NewVertex>>& cycles, double area);

}  // namespace limpet::geometry
