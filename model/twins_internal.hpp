// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include "segment_internal.hpp"
#include "setting_internal.hpp"

namespace limpet::model::internal {

/// Are two mature polygons one surface (rule `twins`), although their planes differ by more than their
/// readings explain? They are if the angle between them is below μ, more than half of the smaller perimeter's
/// vertices are inside the other, and the readings of the smaller one are as a whole within half the
/// tolerance of the other's plane, or within the tolerance and on both sides of it. Two faces that meet in an
/// edge, or a step between them, lie beside each other. `residual2`: the mean squared height of the smaller
/// one's readings over the other's plane of best fit.
bool are_twins(const Setting&, const Segment& large, const Segment& small, double residual2);

}  // namespace limpet::model::internal
