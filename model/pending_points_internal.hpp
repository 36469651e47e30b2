// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <deque>

#include "complex_internal.hpp"

namespace limpet::model::internal {

/// Sensor points that are to be inserted, for the first time or again.
using PendingPoints = std::deque<RawPoint>;

/// Deletes a young segment; its points are pending again. `count_return`: it counts towards their
/// kMaxReturns.
void release_points(Complex&, PendingPoints&, const Segment& young, bool count_return);

}  // namespace limpet::model::internal
