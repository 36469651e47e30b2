// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <vector>

#include <limpet/geometry/polygon.hpp>

namespace limpet::geometry {

/// Cycles that were brought from one chart into another are no longer valid where rounding has carried a
/// vertex onto an edge or over it: such vertices are moved back to their side, by at most two grid steps
/// along each axis. `before` are the same cycles, vertex by vertex, where they were valid; the charts face
/// the same way. Nothing else changes. False when edges are still in conflict after a few rounds.
///  (1) When true, no edges are in conflict; when false, the cycles are as they were, and they are
///      as well when no edges were in conflict;
///  (2) no vertex moves farther than that, in however many conflicts it is.
bool restore_sides(std::vector<std::vector<NewVertex>>& cycles,
                   const std::vector<std::vector<NewVertex>>& before);

/// Mends cycles that rounding broke (outer first): vertices closer than two grid steps to the one before go,
/// then, as long as edges conflict, the end of theirs whose removal changes the least area. Thin spikes
/// and necks vanish by that. Edges that change lose their identities. False when the outer cycle does not
/// survive, or the mending changes more than `area` (grid steps squared) in all; holes may vanish. The result
/// still has to be judged.
///  (1) When true, no edges are in conflict;
///  (2) cycles without conflicts or vertices so close stay as they are. But mending twice may
///      change more than mending once: a removal can leave two vertices close;
///  (3) motions (predicates.hpp) keep the outcome, vertex for vertex;
///  (4) when true, the area has changed by at most `area`, and by what went with vertices so
///      close; the cycles are then the same for any larger `area`.
bool mend_cycles(std::vector<std::vector<NewVertex>>& cycles, double area);

}  // namespace limpet::geometry
