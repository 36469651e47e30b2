// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <limpet/io/polygon_mesh.hpp>
#include <limpet/io/triangulate.hpp>
#include <numeric>
#include <unordered_map>

namespace limpet::io {
namespace {

/// Sets of vertices that are one, each named by its lowest member.
class Welds {
 public:
  explicit Welds(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  int find(int vertex) {
    while (parent_[vertex] != vertex) vertex = parent_[vertex] = parent_[parent_[vertex]];
    return vertex;
  }

  void join(int a, int b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

struct EdgeEnds {
  int from, to;
};

/// All vertices of all cycles in a row, and the ends of every edge.
struct Corners {
  std::vector<Eigen::Vector3d> at;
  std::vector<std::uint64_t> partner;
  std::vector<EdgeEnds> ends;
  std::unordered_map<std::uint64_t, int> edge_at;  ///< edge identity to index
};

Corners collect(const std::vector<LiftedPolygon>& polygons) {
  Corners corners;
  for (const LiftedPolygon& polygon : polygons) {
    for (const LiftedCycle& cycle : polygon.cycles) {
      const int begin = static_cast<int>(corners.at.size()), size = static_cast<int>(cycle.size());
      for (int i = 0; i < size; ++i) {
        corners.at.push_back(cycle[i].at);
        corners.partner.push_back(cycle[i].partner);
        corners.ends.push_back({begin + i, begin + (i + 1) % size});
        corners.edge_at.emplace(cycle[i].edge, begin + i);
      }
    }
  }
  return corners;
}

Welds weld(const Corners& corners, double reach) {
  Welds welds(corners.at.size());
  const auto join = [&](int a, int b) {
    if ((corners.at[a] - corners.at[b]).squaredNorm() <= reach * reach) welds.join(a, b);
  };
  for (std::size_t i = 0; i < corners.ends.size(); ++i) {
    if (corners.partner[i] == 0) continue;
    const auto partner = corners.edge_at.find(corners.partner[i]);
    if (partner == corners.edge_at.end()) continue;
    join(corners.ends[i].from, corners.ends[partner->second].to);
    join(corners.ends[i].to, corners.ends[partner->second].from);
  }
  return welds;
}

bool has_repeats(std::vector<int> vertices) {
  std::sort(vertices.begin(), vertices.end());
  return std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end();
}

class MeshMaker {
 public:
  MeshMaker(Corners corners, Welds welds)
      : corners_(std::move(corners)), welds_(std::move(welds)), number_(corners_.at.size(), -1) {}

  /// Adds a face over corners; where welding would pinch it, over its own corners instead.
  void add(std::vector<int> corners, std::uint64_t segment) {
    std::vector<int> welded = corners;
    for (int& corner : welded) corner = welds_.find(corner);
    MeshFace& face = mesh_.faces.emplace_back();
    face.segment = segment;
    for (const int corner : has_repeats(welded) ? corners : welded) face.vertices.push_back(number(corner));
  }

  PolygonMesh take() { return std::move(mesh_); }

 private:
  int number(int corner) {
    if (number_[corner] < 0) {
      number_[corner] = static_cast<int>(mesh_.vertices.size());
      mesh_.vertices.push_back(corners_.at[corner]);
    }
    return number_[corner];
  }

  Corners corners_;
  Welds welds_;
  std::vector<int> number_;
  PolygonMesh mesh_;
};

}  // namespace

PolygonMesh make_mesh(const std::vector<LiftedPolygon>& polygons, double reach, bool triangles_only) {
  Corners corners = collect(polygons);
  Welds welds = weld(corners, reach);
  MeshMaker maker(std::move(corners), std::move(welds));
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
        maker.add(std::move(face), polygon.id);
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
