// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/simulation/mesh.hpp>
#include <string>
#include <vector>

namespace limpet::simulation {

/// A world to be scanned, and where to scan it from so that nearly all of its faces are seen.
struct Scene {
  Mesh mesh;
  std::vector<Eigen::Vector3d> viewpoints;
  double feature = 0;  ///< smallest width a model should show; of a mesh from a file its narrowest_place()
};

/// Makes a named shape (shapes.hpp) or else reads the mesh file of that name. Throws MeshError.
Scene make_scene(const std::string& shape_or_path);

/// Is it a shape's name, or does it end as a mesh file's?
bool is_scene_name(const std::string& name);

/// Around the mesh, two diagonals of its bounding box away: the directions of a cube's eight corners and,
/// if asked for, of its six faces. None is quite symmetric, so no ray runs along an axis-parallel edge.
std::vector<Eigen::Vector3d> viewpoints_around(const Mesh& mesh, bool with_faces);

/// Above a height field, two diagonals away: eight azimuths at an elevation of about 45°, and the zenith.
std::vector<Eigen::Vector3d> viewpoints_above(const Mesh& mesh);

}  // namespace limpet::simulation
