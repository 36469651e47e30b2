// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/model/model.hpp>
#include <limpet/simulation/mesh.hpp>
#include <vector>

namespace limpet::simulation {

/// The planar faces of a mesh as faces known beforehand (thesis §4.3), for Model::add_initial().
std::vector<model::InitialFace> initial_faces(const Mesh& mesh);

/// The same for some of the faces, in this order: of a range image, occluded_faces(). Throws MeshError when
/// the mesh has no face of such a number.
std::vector<model::InitialFace> initial_faces(const Mesh& mesh, const std::vector<int>& faces);

}  // namespace limpet::simulation
