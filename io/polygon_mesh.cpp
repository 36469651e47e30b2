// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <limpet/io/polygon_mesh.hpp>
#include <limpet/io/triangulate.hpp>
#include <limpet/io/welded.hpp>
#include <numeric>

namespace limpet::io {
namespace {

bool has_repeats(std::vector<int> vertices) {
  std::sort(vertices.begin(), vertices.end());
  return std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end();
}

class MeshMaker {
 public:
  MeshMaker(const std::vector<LiftedPolygon>& polygons, WeldedVertices welds)
      : welds_(std::move(welds)), number_(welds_.at.size(), -1), own_number_(welds_.welded.size(), -1) {
    for (const LiftedPolygon& polygon : polygons)
      for (const LiftedCycle& cycle : polygon.cycles)
        for (const LiftedVertex& vertex : cycle) own_.push_back(vertex.at);
  }

  /// Adds a face over lifted vertices; where welding would pinch it, over its own.
  void add(const std::vector<int>& vertices, std::uint64_t segment) {
    std::vector<int> welded;
    for (const int v : vertices) welded.push_back(welds_.welded[v]);
    MeshFace& face = mesh_.faces.emplace_back();
    face.segment = segment;
    const bool pinched = has_repeats(welded);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      face.vertices.push_back(pinched ? numbered(own_number_[vertices[i]], own_[vertices[i]])
                                      : numbered(number_[welded[i]], welds_.at[welded[i]]));
  }

  PolygonMesh take() { return std::move(mesh_); }

 private:
  int numbered(int& number, const Eigen::Vector3d& at) {
    if (number < 0) {
      number = static_cast<int>(mesh_.vertices.size());
      mesh_.vertices.push_back(at);
    }
    return number;
  }

  WeldedVertices welds_;
  std::vector<Eigen::Vector3d> own_;
  std::vector<int> number_, own_number_;
  PolygonMesh mesh_;
};

}  // namespace

PolygonMesh make_mesh(const std::vector<LiftedPolygon>& polygons, double reach, bool triangles_only) {
  MeshMaker maker(polygons, weld(polygons, reach));
  int begin = 0;
  for (const LiftedPolygon& polygon : polygons) {
    int size = 0;
    std::vector<std::vector<Eigen::Vector2d>> charts;
    for (const LiftedCycle& cycle : polygon.cycles) {
      size += static_cast<int>(cycle.size());
      auto& chart = charts.emplace_back();
      for (const LiftedVertex& vertex : cycle) chart.push_back(vertex.chart);
    }
    if (!polygon.cycles.empty() && polygon.cycles[0].size() >= 3) {
      if (polygon.cycles.size() == 1 && !triangles_only) {
        std::vector<int> face(static_cast<std::size_t>(size));
        std::iota(face.begin(), face.end(), begin);
        maker.add(face, polygon.id);
      } else {
        for (const auto& [a, b, c] : triangulate(charts)) {
          maker.add({begin + a, begin + b, begin + c}, polygon.id);
        }
      }
    }
    begin += size;
  }
  return maker.take();
}

}  // namespace limpet::io
