// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <vector>

#include "../../tests/cases/perimeter_case.hpp"
#include "builds.hpp"

/// What all builds are given: made by the exact one.
namespace limpet::benchmarks {

/// Cases of one step each, as the exact build comes upon them when it grows polygons by random operations;
/// `each` of every operation.
std::vector<cases::PerimeterCase> record_operations(const Setting&, std::size_t each, std::uint64_t seed);

/// Pairs of overlapping polygons, as cases of one union; whole numbers below 2^41. Degenerate ones are made
/// in units of 2^10 steps. The same pairs in each regime: as they are, turned by an angle and rounded, moved
/// a million times their extent away. Their gap is half a unit.
std::vector<cases::PerimeterCase> record_pairs(const Setting&, std::size_t count, std::uint64_t seed);

}  // namespace limpet::benchmarks
