// Copyright the limpet authors. GPL-3.0-or-later.
#include <array>
#include <vector>

#include "placed_object_internal.hpp"

namespace limpet::app::internal {
namespace {

using Eigen::Vector3d;
using simulation::Mesh;

Mesh mesh_of_faces(const std::vector<model::InitialFace>& faces) {
  if (faces.empty()) return {};
  std::vector<Vector3d> vertices;
  std::vector<std::vector<int>> polygons;
  for (const model::InitialFace& face : faces) {
    polygons.emplace_back();
    for (const Vector3d& corner : face.cycles.front()) {
      polygons.back().push_back(static_cast<int>(vertices.size()));
      vertices.push_back(corner);
    }
  }
  return simulation::make_mesh(vertices, polygons);
}

/// Faces have no part in how far a mesh is: there are none here.
void add_point(const Vector3d& point, double grain, Mesh& mesh) {
  const int first = static_cast<int>(mesh.vertices.size());
  for (const Vector3d& corner : {Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 1)})
    mesh.vertices.push_back(point + grain * corner);
  mesh.triangles.push_back({first, first + 1, first + 2});
}

Mesh known_of(const simulation::BuiltWorld& world, double grain) {
  if (world.truth) return *world.truth;
  Mesh mesh = mesh_of_faces(world.initial);
  for (const Vector3d& point : world.image) add_point(point, grain, mesh);
  return mesh;
}

}  // namespace

PlacedObject::PlacedObject(const simulation::BuiltWorld& world, double grain)
    : PlacedObject(known_of(world, grain)) {}

PlacedObject::PlacedObject(const Mesh& mesh) : bounds_(simulation::bounds_of(mesh)), surface_(mesh) {}

}  // namespace limpet::app::internal
