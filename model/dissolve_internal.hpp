// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include "complex_internal.hpp"
#include "insertion_internal.hpp"

/// Segments that are taken apart, their points to be inserted again.
namespace limpet::model::internal {

/// Young segments of which many points fit mature polygons now (rule `dissolve`); whether there were any.
bool dissolve_young(Complex&, Agenda&, Insertion&);
/// Young polygons to which far fewer points came than to the rest of the scene (rule `arrival`).
void release_slow_polygons(Complex&, Insertion&);
/// Young point segments, at the end of input: the model has grown since they came.
void release_all_point_segments(Complex&, Insertion&);

}  // namespace limpet::model::internal
