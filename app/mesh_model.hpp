// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/model/model.hpp>
#include <string>
#include <vector>

namespace limpet::app {

/// The planar faces of a mesh file, as faces known beforehand (thesis §4.3). Throws simulation::MeshError.
std::vector<model::InitialFace> initial_faces(const std::string& path);

/// A mesh file or a shape as a model of faces known beforehand, with the edges that they share: so a truth is
/// drawn as models are. Faces that are no simple polygons are left out, with a warning. Throws
/// simulation::MeshError.
model::ModelRecord model_of_mesh(const std::string& path);

/// Is it a shape's name, or does it end as a mesh file's?
bool is_mesh_name(const std::string& path);

}  // namespace limpet::app
