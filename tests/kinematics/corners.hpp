// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/simulation/mesh.hpp>
#include <vector>

namespace limpet::kinematics::testing {

/// The corners of a mesh's triangles, three after three.
inline std::vector<Eigen::Vector3d> corners_of(const simulation::Mesh& mesh) {
  std::vector<Eigen::Vector3d> corners;
  for (const auto& triangle : mesh.triangles)
    for (const int i : triangle) corners.push_back(mesh.vertices[static_cast<std::size_t>(i)]);
  return corners;
}

}  // namespace limpet::kinematics::testing
