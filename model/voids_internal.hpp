// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstddef>
#include <cstdint>

#include "complex_internal.hpp"

/// Holes and bays that chance alone explains, and parts that are no surface (rules `voids` and `spurs`).
namespace limpet::model::internal {

/// Would chance alone leave this area empty between k of m points of which there are `density` to a unit of
/// area? Lengths in grid steps.
bool empty_by_chance(double area, std::size_t k, std::int64_t m, double density, double gap);
/// The same of a bay in the segment's perimeter, or a hole, with k points around it.
bool empty_by_chance(const Setting&, const Segment&, double area, std::size_t k);
/// Drops the holes of a polygon that chance alone leaves; whether there were any.
bool drop_chance_holes(Complex&, const Segment&);
/// Is a part of a polygon that goes on beyond a line so thin, or so small, that it is no surface at this
/// resolution? Lengths in grid steps.
bool is_spur(const Setting&, double area, double depth);

}  // namespace limpet::model::internal
