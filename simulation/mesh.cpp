// Copyright the limpet authors. GPL-3.0-or-later.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limpet/simulation/mesh.hpp>
#include <map>
#include <numeric>

namespace limpet::simulation {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Triangle = std::array<int, 3>;

/// So that the squares of areas are finite.
constexpr double kFarthest = 1e75;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Merges vertices at the same position; returns the new index of every old one.
std::vector<int> weld(const std::vector<Vector3d>& vertices, std::vector<Vector3d>& welded) {
  std::map<std::array<double, 3>, int> index;
  std::vector<int> renamed;
  renamed.reserve(vertices.size());
  for (const Vector3d& v : vertices) {
    if (!v.allFinite()) throw MeshError("a vertex has a coordinate that is not finite");
    if (v.cwiseAbs().maxCoeff() > kFarthest) throw MeshError("a vertex has a coordinate beyond 1e75");
    const std::array<double, 3> key{v.x() + 0.0, v.y() + 0.0, v.z() + 0.0};  // −0 becomes 0
    const auto [at, is_new] = index.try_emplace(key, static_cast<int>(welded.size()));
    if (is_new) welded.emplace_back(key[0], key[1], key[2]);
    renamed.push_back(at->second);
  }
  return renamed;
}

/// The corners of a polygon in its own plane (Newell's normal).
std::vector<Vector2d> flattened(const std::vector<int>& polygon, const std::vector<Vector3d>& vertices) {
  Vector3d normal = Vector3d::Zero();
  const Vector3d& origin = vertices[polygon[0]];
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3d a = vertices[polygon[i]] - origin;
    const Vector3d b = vertices[polygon[(i + 1) % polygon.size()]] - origin;
    normal += a.cross(b);
  }
  int drop = 0;
  normal.cwiseAbs().maxCoeff(&drop);
  // Leaving out the coordinate of the largest component is an affine map: it keeps what is inside what.
  const int x = normal[drop] > 0 ? (drop + 1) % 3 : (drop + 2) % 3;
  const int y = normal[drop] > 0 ? (drop + 2) % 3 : (drop + 1) % 3;
  std::vector<Vector2d> flat;
  for (const int v : polygon) flat.emplace_back(vertices[v][x] - origin[x], vertices[v][y] - origin[y]);
  return flat;
}

/// How good an ear the corner at `ring[i]` is: the sine-like measure of its angle, or −1 if it is none.
double ear_quality(const std::vector<int>& ring, std::size_t i, const std::vector<Vector2d>& flat) {
  const std::size_t n = ring.size();
  const int ia = ring[(i + n - 1) % n], ib = ring[i], ic = ring[(i + 1) % n];
  const Vector2d &a = flat[ia], &b = flat[ib], &c = flat[ic];
  const double twice_area = cross(b - a, c - b);
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  if (twice_area <= 1e-14 * longest) return -1;
  for (const int other : ring) {
    const Vector2d& p = flat[other];
    if (p == a || p == b || p == c) continue;  // also the other copy of a bridge's end
    if (cross(b - a, p - a) >= 0 && cross(c - b, p - b) >= 0 && cross(a - c, p - c) >= 0) return -1;
  }
  return twice_area / longest;
}

/// Cuts a polygon into triangles by clipping its best ear again and again. Unlike the constrained
/// triangulation of io/triangulate.hpp this takes polygons whose boundary runs twice along a bridge to a
/// hole, as mesh files have them.
void triangulate(const std::vector<int>& polygon, const std::vector<Vector3d>& vertices,
                 std::vector<Triangle>& out) {
  if (polygon.size() == 3) {
    out.push_back({polygon[0], polygon[1], polygon[2]});
    return;
  }
  const std::vector<Vector2d> flat = flattened(polygon, vertices);
  std::vector<int> ring(polygon.size());
  std::iota(ring.begin(), ring.end(), 0);
  while (ring.size() > 3) {
    std::size_t best = 0;
    double quality = -2;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const double q = ear_quality(ring, i, flat);
      if (q > quality) {
        quality = q;
        best = i;
      }
    }
    const std::size_t n = ring.size();
    out.push_back({polygon[ring[(best + n - 1) % n]], polygon[ring[best]], polygon[ring[(best + 1) % n]]});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(best));
  }
  out.push_back({polygon[ring[0]], polygon[ring[1]], polygon[ring[2]]});
}

using EdgeKey = std::pair<int, int>;
struct EdgeUse {
  EdgeKey edge;  ///< directed
  int triangle;
  bool operator<(const EdgeUse& o) const { return std::tie(edge, triangle) < std::tie(o.edge, o.triangle); }
};

std::vector<EdgeUse> directed_edges(const std::vector<Triangle>& triangles) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) uses.push_back({{triangles[t][k], triangles[t][(k + 1) % 3]}, t});
  std::sort(uses.begin(), uses.end());
  return uses;
}

/// Grows each face from its largest triangle, whose plane is known best.
void find_faces(Mesh& mesh, double planarity) {
  const int count = static_cast<int>(mesh.triangles.size());
  const double reach = planarity * bounds_of(mesh).diagonal();
  const std::vector<EdgeUse> uses = directed_edges(mesh.triangles);
  std::vector<Vector3d> area(count);
  for (int t = 0; t < count; ++t) area[t] = area_vector(mesh, t);
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return area[a].squaredNorm() > area[b].squaredNorm(); });

  std::vector<int> seed_of(count, -1), waiting;
  for (const int seed : order) {
    if (seed_of[seed] >= 0) continue;
    const Vector3d origin = mesh.vertices[mesh.triangles[seed][0]];
    const Vector3d normal = area[seed].normalized();
    const auto belongs = [&](int t) {
      // A sliver's normal says nothing, so its corners decide; a proper triangle must also face this way.
      if (area[t].dot(normal) < 0 && area[t].norm() > reach * reach) return false;
      return std::all_of(mesh.triangles[t].begin(), mesh.triangles[t].end(),
                         [&](int v) { return std::abs(normal.dot(mesh.vertices[v] - origin)) <= reach; });
    };
    seed_of[seed] = seed;
    waiting.assign(1, seed);
    while (!waiting.empty()) {
      const Triangle corner = mesh.triangles[waiting.back()];
      waiting.pop_back();
      for (int k = 0; k < 3; ++k) {
        const EdgeKey twin{corner[(k + 1) % 3], corner[k]};
        for (auto use = std::lower_bound(uses.begin(), uses.end(), EdgeUse{twin, 0});
             use != uses.end() && use->edge == twin; ++use) {
          if (seed_of[use->triangle] >= 0 || !belongs(use->triangle)) continue;
          seed_of[use->triangle] = seed;
          waiting.push_back(use->triangle);
        }
      }
    }
  }

  std::vector<int> number(count, -1);
  mesh.face_count = 0;
  mesh.face_of_triangle.resize(count);
  for (int t = 0; t < count; ++t) {
    int& face = number[seed_of[t]];
    if (face < 0) face = mesh.face_count++;
    mesh.face_of_triangle[t] = face;
  }
}

}  // namespace

Mesh make_mesh(const std::vector<Vector3d>& vertices, const std::vector<std::vector<int>>& polygons,
               double planarity) {
  Mesh mesh;
  const std::vector<int> renamed = weld(vertices, mesh.vertices);
  for (const std::vector<int>& polygon : polygons) {
    std::vector<int> ring;
    for (const int v : polygon) {
      if (v < 0 || v >= static_cast<int>(vertices.size()))
        throw MeshError("a face names a vertex that is not there");
      if (ring.empty() || ring.back() != renamed[v]) ring.push_back(renamed[v]);
    }
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    if (ring.size() < 3) continue;
    triangulate(ring, mesh.vertices, mesh.triangles);
  }
  std::erase_if(mesh.triangles,
                [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  if (mesh.triangles.empty()) throw MeshError("the mesh has no face");
  find_faces(mesh, planarity);
  return mesh;
}

Bounds bounds_of(const Mesh& mesh) {
  Bounds box{mesh.vertices.front(), mesh.vertices.front()};
  for (const Vector3d& v : mesh.vertices) {
    box.low = box.low.cwiseMin(v);
    box.high = box.high.cwiseMax(v);
  }
  return box;
}

Vector3d area_vector(const Mesh& mesh, int triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const Vector3d& origin = mesh.vertices[a];
  return (mesh.vertices[b] - origin).cross(mesh.vertices[c] - origin);
}

double signed_volume(const Mesh& mesh) {
  const Vector3d origin = bounds_of(mesh).centre();
  double sum = 0;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    sum += (mesh.vertices[mesh.triangles[t][0]] - origin).dot(area_vector(mesh, t)) / 6;
  return sum;
}

EdgeCounts count_edges(const Mesh& mesh) {
  std::map<EdgeKey, std::pair<int, int>> both_ways;
  for (const EdgeUse& use : directed_edges(mesh.triangles)) {
    const auto [a, b] = use.edge;
    auto& [forth, back] = both_ways[std::minmax(a, b)];
    ++(a < b ? forth : back);
  }
  EdgeCounts counts;
  counts.edges = static_cast<long>(both_ways.size());
  for (const auto& [edge, uses] : both_ways) {
    if (uses.first + uses.second == 1) ++counts.open;
    if (uses.first > 1 || uses.second > 1) ++counts.crowded;
  }
  return counts;
}

}  // namespace limpet::simulation
