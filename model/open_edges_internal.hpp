// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <vector>

#include <limpet/model/open_edges.hpp>

#include "complex_internal.hpp"

namespace limpet::model::internal {

/// For each open edge the condition that refuses it a neighbour, with sections searched for within this
/// reach. See Model::open_edges().
std::vector<OpenEdge> open_edges(const Complex&, const SharingReach&);

}  // namespace limpet::model::internal
