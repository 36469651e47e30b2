// Copyright the limpet authors. GPL-3.0-or-later.
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <limpet/io/triangulate.hpp>
#include <utility>

namespace limpet::io {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
struct VertexInfo {
  int index = -1;  // -1: made by the triangulation where two edges cross
};
struct FaceInfo {
  int crossings = -1;  // cycles between the face and the outside; -1: not visited yet
};
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<VertexInfo, Kernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel>;
using Face = CGAL::Constrained_triangulation_face_base_2<Kernel, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Face>,
                                               CGAL::Exact_predicates_tag>;

using Cycles = std::vector<std::vector<Eigen::Vector2d>>;

/// All vertices first, so that each has its index even where an edge runs through it.
Triangulation constrain(const Cycles& cycles) {
  Triangulation triangulation;
  int index = 0;
  std::vector<std::pair<Triangulation::Vertex_handle, Triangulation::Vertex_handle>> edges;
  for (const auto& cycle : cycles) {
    std::vector<Triangulation::Vertex_handle> vertices;
    for (const Eigen::Vector2d& at : cycle) {
      const auto vertex = triangulation.insert({at.x(), at.y()});
      if (vertex->info().index < 0) vertex->info().index = index;
      vertices.push_back(vertex);
      ++index;
    }
    if (cycle.size() < 3) continue;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      edges.emplace_back(vertices[i], vertices[(i + 1) % vertices.size()]);
    }
  }
  for (const auto& [from, to] : edges) {
    if (from != to) triangulation.insert_constraint(from, to);
  }
  return triangulation;
}

/// Cycle by cycle; of vertices at one place one is left.
Triangulation constrain_in_turn(const Cycles& cycles) {
  Triangulation triangulation;
  for (const auto& cycle : cycles) {
    Triangulation::Vertex_handle first, last;
    for (const Eigen::Vector2d& at : cycle) {
      const auto vertex = triangulation.insert({at.x(), at.y()});
      if (last != nullptr && last != vertex) triangulation.insert_constraint(last, vertex);
      if (first == nullptr) first = vertex;
      last = vertex;
    }
    if (last != first) triangulation.insert_constraint(last, first);
  }
  return triangulation;
}

/// Counts, for every face, the constraints between it and the outside.
void count_crossings(Triangulation& triangulation) {
  std::vector<Triangulation::Face_handle> inner = {triangulation.infinite_face()}, next;
  for (int crossings = 0; !inner.empty(); ++crossings) {
    while (!inner.empty()) {
      const auto face = inner.back();
      inner.pop_back();
      if (face->info().crossings >= 0) continue;
      face->info().crossings = crossings;
      for (int i = 0; i < 3; ++i) {
        const auto beyond = face->neighbor(i);
        if (beyond->info().crossings >= 0) continue;
        (face->is_constrained(i) ? next : inner).push_back(beyond);
      }
    }
    std::swap(inner, next);
  }
}

/// Hands out the faces inside an odd number of cycles.
template <class Take>
void for_each_inside(Triangulation triangulation, Take&& take) {
  if (triangulation.dimension() < 2) return;
  count_crossings(triangulation);
  for (const auto face : triangulation.finite_face_handles())
    if (face->info().crossings % 2 != 0) take(face);
}

}  // namespace

std::vector<Triangle> triangulate(const Cycles& cycles) {
  std::vector<Triangle> triangles;
  for (const auto& cycle : cycles) {
    for (const Eigen::Vector2d& at : cycle) {
      if (!at.allFinite()) return triangles;  // a broken model is drawn without its broken polygon
    }
  }
  for_each_inside(constrain(cycles), [&](const Triangulation::Face_handle face) {
    const Triangle triangle = {face->vertex(0)->info().index, face->vertex(1)->info().index,
                               face->vertex(2)->info().index};
    if (triangle[0] >= 0 && triangle[1] >= 0 && triangle[2] >= 0) triangles.push_back(triangle);
  });
  return triangles;
}

std::vector<FlatTriangle> triangulate_crossing(const Cycles& cycles) {
  std::vector<FlatTriangle> triangles;
  for_each_inside(constrain_in_turn(cycles), [&](const Triangulation::Face_handle face) {
    FlatTriangle& triangle = triangles.emplace_back();
    for (int k = 0; k < 3; ++k) triangle[k] = {face->vertex(k)->point().x(), face->vertex(k)->point().y()};
  });
  return triangles;
}

}  // namespace limpet::io
