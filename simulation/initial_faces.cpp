// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/simulation/initial_faces.hpp>

namespace limpet::simulation {

std::vector<model::InitialFace> initial_faces(const Mesh& mesh) {
  std::vector<model::InitialFace> result;
  for (const Face& face : faces_of(mesh)) result.push_back({face.loops});
  return result;
}

}  // namespace limpet::simulation
