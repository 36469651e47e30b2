// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include "complex_internal.hpp"
#include "insertion_internal.hpp"

/// Dissolving segments: they are deleted, and their points are inserted again.
namespace limpet::model::internal {

/// Dissolves young segments of which a fifth of the points fit mature polygons, and polygons about to become
/// mature that got too few points (rules `dissolve`, `arrival`). Returns whether there were any.
bool dissolve_young(Complex&, Agenda&, Insertion&);
/// Dissolves young polygons that got far fewer points than the rest of the scene (rule `arrival`).
void release_slow_polygons(Complex&, Insertion&);
/// Dissolves all young point segments at the end of input, as the model has grown since their points came.
void release_all_point_segments(Complex&, Insertion&);

}  // namespace limpet::model::internal
