// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstddef>
#include <cstdint>

#include "complex_internal.hpp"

/// Holes and bays that may be chance gaps between the readings (rule `voids`), and parts of polygons that are
/// no surface (rule `spurs`).
namespace limpet::model::internal {

/// May an area with k vertices around it be empty by chance, if m points are spread with this density (points
/// per unit of area)? Lengths in grid steps; `gap`: λ.
bool empty_by_chance(double area, std::size_t k, std::int64_t m, double density, double gap);
/// The same for a bay in the segment's perimeter, or a hole, at the density of the segment. False if it has
/// no points.
bool empty_by_chance(const Setting&, const Segment&, double area, std::size_t k);
/// Drops the holes of a polygon that may be chance gaps, except footprints of other segments. Returns whether
/// there were any.
bool drop_chance_holes(Complex&, const Segment&);
/// Is a part of a polygon beyond a line so thin, or so small, that it is no surface at this resolution (rule
/// `spurs`)? `depth`: how far it reaches. Lengths in grid steps.
bool is_spur(const Setting&, double area, double depth);

}  // namespace limpet::model::internal
