// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/following/observation.hpp>
#include <vector>

#include "expected_planes_internal.hpp"
#include "outlook_internal.hpp"
#include "place_memory_internal.hpp"

namespace limpet::following::internal {

constexpr double kThrough = 0.4;              ///< λ: a ray goes through a place
constexpr double kLeastThroughCosine = 0.25;  ///< of its incidence

/// What of each sensor's ray is known to be free, but for the last bit: a surface a little before the one
/// that is expected is the same. A reading may be λ beside its axis.
std::vector<Ray> free_rays(const Observation&, double resolution);

/// Remembers the targets that a ray went through.
void note_empty(const std::vector<Target>&, const std::vector<Ray>&, double resolution, PlaceMemory&);

}  // namespace limpet::following::internal
