// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <limpet/io/text.hpp>
#include <limpet/simulation/scene.hpp>
#include <limpet/simulation/shapes.hpp>
#include <limpet/simulation/shapes_internal.hpp>

namespace limpet::simulation {
namespace {

using Eigen::Vector3d;

const Vector3d kAsymmetry(0.083, -0.057, 0.041);

Vector3d viewpoint(const Mesh& mesh, const Vector3d& towards) {
  const Bounds bounds = bounds_of(mesh);
  return bounds.centre() + 2 * bounds.diagonal() * (towards.normalized() + kAsymmetry).normalized();
}

/// Where the aisles between the furniture cross, at several heights: low ones see the sides, high ones the
/// tops.
std::vector<Vector3d> viewpoints_in_room(const Mesh& room) {
  const double margin = 0.3125;  // half of the narrowest aisle along a wall
  const Vector3d size = bounds_of(room).high;
  std::vector<Vector3d> viewpoints;
  for (int row = 0; row * kRoomCell <= size.y(); ++row) {
    for (int column = 0; column * kRoomCell <= size.x(); ++column) {
      const double x = std::clamp(column * kRoomCell, margin, size.x() - margin);
      const double y = std::clamp(row * kRoomCell, margin, size.y() - margin);
      viewpoints.emplace_back(x + 0.013, y - 0.017, (row + column) % 2 == 0 ? 0.61 : 1.57);
      if (row % 2 == 1 && column % 2 == 1) viewpoints.emplace_back(x + 0.019, y - 0.011, 2.63);
    }
  }
  return viewpoints;
}

}  // namespace

bool is_scene_name(const std::string& name) {
  if (is_shape(name)) return true;
  const std::string extension = io::extension_of(name);
  return extension == "off" || extension == "stl" || extension == "obj" || extension == "ply";
}

std::vector<Vector3d> viewpoints_around(const Mesh& mesh, bool with_faces) {
  std::vector<Vector3d> viewpoints;
  for (int corner = 0; corner < 8; ++corner)
    viewpoints.push_back(
        viewpoint(mesh, Vector3d(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1)));
  for (int side = 0; with_faces && side < 6; ++side) {
    Vector3d towards = Vector3d::Zero();
    towards[side / 2] = side % 2 == 0 ? 1 : -1;
    viewpoints.push_back(viewpoint(mesh, towards));
  }
  return viewpoints;
}

std::vector<Vector3d> viewpoints_above(const Mesh& mesh) {
  std::vector<Vector3d> viewpoints;
  const double slant = 1;  // horizontal part of the direction for a vertical part of 1
  const double directions[8][2] = {{1, 0},  {0.7, 0.7},   {0, 1},  {-0.7, 0.7},
                                   {-1, 0}, {-0.7, -0.7}, {0, -1}, {0.7, -0.7}};
  for (const auto& [x, y] : directions)
    viewpoints.push_back(viewpoint(mesh, Vector3d(slant * x, slant * y, 1)));
  viewpoints.push_back(viewpoint(mesh, Vector3d::UnitZ()));
  return viewpoints;
}

Scene make_scene(const std::string& shape_or_path) {
  if (!is_shape(shape_or_path)) {
    Mesh mesh = load_mesh(shape_or_path);
    std::vector<Vector3d> viewpoints = viewpoints_around(mesh, true);
    const double feature = narrowest_place(mesh);
    return {std::move(mesh), std::move(viewpoints), feature};
  }
  Scene scene{make_shape(shape_or_path), {}, feature_size(shape_or_path)};
  if (shape_or_path.starts_with("room"))
    scene.viewpoints = viewpoints_in_room(scene.mesh);
  else if (shape_or_path.starts_with("city"))
    scene.viewpoints = viewpoints_above(scene.mesh);
  else
    scene.viewpoints = viewpoints_around(scene.mesh, false);
  return scene;
}

}  // namespace limpet::simulation
