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

}  // namespace limpet::model::internal
