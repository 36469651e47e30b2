// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <vector>

#include <limpet/geometry/polygon.hpp>

namespace limpet::geometry {

/// Mends cycles that rounding broke (outer first): vertices closer than two grid steps to the one before go,
/// then, as long as two edges conflict, the end of theirs whose removal changes the least area. Thin spikes
/// and necks vanish by that. Edges that change lose their identities. False when the outer cycle does not
/// survive, or the mending changes more than `area` (grid steps squared) in all; holes may vanish. The result
/// still has to be judged.
bool mend_cycles(std::vector<std::vector<NewVertex>>& cycles, double area);

}  // namespace limpet::geometry
