// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/model/model.hpp>
#include <string>
#include <vector>

namespace limpet::app {

/// The planar faces of a mesh file, as faces known beforehand (thesis §4.3). Throws simulation::MeshError.
std::vector<model::InitialFace> initial_faces(const std::string& path);

/// The planar faces of a mesh file or a shape as a model's, each side with the one it shares: so a truth is
/// drawn as models are. For drawing alone: it has no grid and no points. Throws simulation::MeshError.
model::ModelRecord model_of_mesh(const std::string& path);

/// Is it a shape's name, or does it end as a mesh file's?
bool is_mesh_name(const std::string& path);

}  // namespace limpet::app
