// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/simulation/initial_faces.hpp>

#include <numeric>
#include <string>

namespace limpet::simulation {

std::vector<model::InitialFace> initial_faces(const Mesh& mesh) {
  std::vector<int> all(static_cast<std::size_t>(mesh.face_count));
  std::iota(all.begin(), all.end(), 0);
  return initial_faces(mesh, all);
}

std::vector<model::InitialFace> initial_faces(const Mesh& mesh, const std::vector<int>& faces) {
  const std::vector<Face> known = faces_of(mesh);
  std::vector<model::InitialFace> result;
  for (const int face : faces) {
    if (face < 0 || face >= mesh.face_count)
      throw MeshError("there is no face " + std::to_string(face) + ": the faces of the mesh are 0 to " +
                      std::to_string(mesh.face_count - 1));
    result.push_back({known[static_cast<std::size_t>(face)].loops});
  }
  return result;
}

}  // namespace limpet::simulation
