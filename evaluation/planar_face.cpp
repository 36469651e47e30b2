// Copyright the limpet authors. GPL-3.0-or-later.
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>

#include <Eigen/Geometry>
#include <limpet/evaluation/planar_face.hpp>
#include <vector>

namespace limpet::evaluation {
namespace {

using Eigen::Vector3d;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_2<Kernel>;
/// The info is how many times the boundary is crossed on the way from infinity; −1: not known yet.
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Kernel,
                                                CGAL::Triangulation_face_base_with_info_2<int, Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>, CGAL::Exact_predicates_tag>;

void count_crossings(Triangulation& triangulation) {
  for (const auto& face : triangulation.all_face_handles()) face->info() = -1;
  std::vector<Triangulation::Face_handle> now{triangulation.infinite_face()}, next;
  for (int crossings = 0; !now.empty(); ++crossings) {
    while (!now.empty()) {
      const Triangulation::Face_handle face = now.back();
      now.pop_back();
      if (face->info() >= 0) continue;
      face->info() = crossings;
      for (int side = 0; side < 3; ++side)
        (face->is_constrained(side) ? next : now).push_back(face->neighbor(side));
    }
    now.swap(next);
  }
}

}  // namespace

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

  Triangulation triangulation;
  for (const auto& cycle : face.cycles) {
    Triangulation::Vertex_handle first, last;
    for (const Vector3d& p : cycle) {
      const auto vertex = triangulation.insert({(p - origin).dot(u), (p - origin).dot(v)});
      if (last != nullptr && last != vertex) triangulation.insert_constraint(last, vertex);
      if (first == nullptr) first = vertex;
      last = vertex;
    }
    if (last != first) triangulation.insert_constraint(last, first);
  }
  if (triangulation.dimension() < 2) return {};
  count_crossings(triangulation);

  std::vector<Triangle3> triangles;
  for (const auto& inside : triangulation.finite_face_handles()) {
    if (inside->info() % 2 == 0) continue;
    Triangle3& triangle = triangles.emplace_back();
    for (int k = 0; k < 3; ++k) {
      const Kernel::Point_2& p = inside->vertex(k)->point();
      triangle[k] = origin + p.x() * u + p.y() * v;
    }
  }
  return triangles;
}

std::vector<PlanarFace> planar_faces(const model::ModelRecord& record) {
  std::vector<PlanarFace> faces;
  for (const model::PolygonSegmentRecord& segment : record.polygon_segments) {
    PlanarFace& face = faces.emplace_back();
    face.id = segment.id;
    face.points = segment.moments.count;
    const auto& [h0, hx, hy] = segment.height;
    face.normal = (segment.chart_normal - hx * segment.chart_u - hy * segment.chart_v).normalized();
    for (const std::vector<model::VertexRecord>& cycle : segment.cycles) {
      std::vector<Vector3d>& lifted = face.cycles.emplace_back();
      for (const model::VertexRecord& vertex : cycle) {
        const double height = h0 + hx * vertex.x + hy * vertex.y;
        lifted.push_back(segment.chart_origin +
                         record.grid_step * (vertex.x * segment.chart_u + vertex.y * segment.chart_v +
                                             height * segment.chart_normal));
      }
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
