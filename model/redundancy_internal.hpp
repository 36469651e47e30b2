// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/model/model.hpp>

#include "complex_internal.hpp"
#include "labels_internal.hpp"

namespace limpet::model::internal {

/// Called when two segments that are not neighbours have found no edge to share: notes the smaller one on the
/// agenda if it is redundant by ψ and φ (thesis §2.9).
void note_if_redundant(const Setting&, Agenda&, const Segment&, const Segment&);
/// Deletes the segments that were noted and, when finishing, segments without neighbours that lie on others
/// (rule `position`). Returns whether there were any.
bool delete_redundant(Complex&, Agenda&, Labels&, Counts&);
/// Deletes a polygon, neighbours or not. Its data goes to a polygon that it fits as a whole; else the points
/// that it keeps go, one by one, to polygons that they fit. Returns how many points are given up.
std::int64_t delete_segment(Complex&, Agenda&, Labels&, const Segment&);

}  // namespace limpet::model::internal
