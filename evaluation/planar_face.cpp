// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/evaluation/planar_face.hpp>

#include <Eigen/Geometry>
#include <limpet/io/lifted.hpp>
#include <limpet/io/triangulate.hpp>
#include <utility>

namespace limpet::evaluation {

using Eigen::Vector3d;

std::vector<Triangle3> triangulated(const PlanarFace& face) {
  const Vector3d u = face.normal.unitOrthogonal(), v = face.normal.cross(u);
  Vector3d origin = Vector3d::Zero();
  std::size_t count = 0;
  for (const auto& cycle : face.cycles) {
    for (const Vector3d& p : cycle) origin += p;
    count += cycle.size();
  }
  if (count < 3) return {};
  origin /= static_cast<double>(count);

  std::vector<std::vector<Eigen::Vector2d>> flat;
  for (const auto& cycle : face.cycles) {
    auto& flattened = flat.emplace_back();
    for (const Vector3d& p : cycle) flattened.emplace_back((p - origin).dot(u), (p - origin).dot(v));
  }
  std::vector<Triangle3> triangles;
  for (const io::FlatTriangle& corners : io::triangulate_crossing(flat)) {
    Triangle3& triangle = triangles.emplace_back();
    for (int k = 0; k < 3; ++k) triangle[k] = origin + corners[k].x() * u + corners[k].y() * v;
  }
  return triangles;
}

std::vector<PlanarFace> planar_faces(const model::ModelRecord& record) {
  std::vector<PlanarFace> faces;
  for (const io::LiftedPolygon& polygon : io::lift(record)) {
    PlanarFace& face = faces.emplace_back();
    face.id = polygon.id;
    face.normal = polygon.normal;
    face.points = polygon.points;
    for (const io::LiftedCycle& cycle : polygon.cycles) {
      auto& vertices = face.cycles.emplace_back();
      for (const io::LiftedVertex& vertex : cycle) vertices.push_back(vertex.at);
    }
  }
  return faces;
}

std::vector<PlanarFace> planar_faces(const simulation::Mesh& mesh) {
  std::vector<PlanarFace> faces;
  for (const simulation::Face& face : simulation::faces_of(mesh))
    faces.push_back({faces.size(), face.loops, face.normal, 0});
  return faces;
}

}  // namespace limpet::evaluation
