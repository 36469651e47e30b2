// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/drawing/sheet.hpp>
#include <vector>

namespace limpet::drawing {

/// The order in which to paint faces over each other, farthest first. The order is right wherever the
/// plane of one of two faces separates them and no cycle of overlaps exists, which is nearly always.
/// Elsewhere, and for more than 3000 faces, it is by mean distance.
std::vector<int> depth_order(const std::vector<Patch>& patches);

}  // namespace limpet::drawing
