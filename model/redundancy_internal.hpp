// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/model/model.hpp>

#include "complex_internal.hpp"
#include "labels_internal.hpp"

namespace limpet::model::internal {

/// After the two, no neighbours, found no edge to share: notes the smaller one if it is redundant, by ψ and φ
/// (thesis §2.9).
void note_if_redundant(const Setting&, Agenda&, const Segment&, const Segment&);
/// Deletes what was noted and, when finishing, segments without neighbours that lie on others; whether there
/// were any.
bool delete_redundant(Complex&, Agenda&, Labels&, Counts&);

}  // namespace limpet::model::internal
