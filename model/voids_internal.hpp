// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstddef>
#include <cstdint>

#include "complex_internal.hpp"

/// Holes and bays that may be chance gaps between the readings (rule `voids`), and parts of polygons that are
/// no surface (rule `spurs`).
namespace limpet::model::internal {

/// Drops the holes of a polygon that may be chance gaps, except footprints of other segments. Returns whether
/// there were any.
bool drop_chance_holes(Complex&, const Segment&);
/// Is a part of a polygon beyond a line so thin, or so small, that it is no surface at this resolution (rule
/// `spurs`)? `gap`: λ there; `depth`: how far it reaches. Lengths in grid steps.
bool is_spur(const Rules&, double gap, double area, double depth);

}  // namespace limpet::model::internal
