// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/model/record.hpp>
#include <limpet/simulation/mesh.hpp>

namespace limpet::drawing {

/// The planar faces of a mesh as polygon segments, each side with the one it shares, so that a truth is drawn
/// as models are. For drawing alone: it has no grid, no points and no parameters.
model::ModelRecord record_of(const simulation::Mesh& mesh);

}  // namespace limpet::drawing
