// Copyright the limpet authors. GPL-3.0-or-later.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <limpet/simulation/mesh.hpp>
#include <map>
#include <set>

namespace limpet::simulation {
namespace {

using Eigen::Vector3d;
using Edge = std::pair<int, int>;  ///< directed
using Loop = std::vector<Vector3d>;

/// For each directed edge of a face's triangles, the third vertex of the triangle on its left.
std::map<Edge, int> third_corners(const Mesh& mesh, const std::vector<int>& triangles) {
  std::map<Edge, int> third;
  for (const int t : triangles) {
    const auto& c = mesh.triangles[t];
    for (int k = 0; k < 3; ++k) third.try_emplace({c[k], c[(k + 1) % 3]}, c[(k + 2) % 3]);
  }
  return third;
}

/// The boundary edge that follows a boundary edge: turn about its end through the fan of the face's
/// triangles. Where the face touches itself in one vertex this stays on the same side of it.
Edge next_on_boundary(const std::map<Edge, int>& third, Edge edge) {
  for (std::size_t turns = 0; turns <= third.size(); ++turns) {
    const Edge next{edge.second, third.at(edge)};
    const Edge twin{next.second, next.first};
    if (!third.contains(twin)) return next;
    edge = twin;
  }
  throw MeshError("a face's triangles turn round a vertex for ever");
}

std::vector<std::vector<int>> boundary_loops(const Mesh& mesh, const std::vector<int>& triangles) {
  const std::map<Edge, int> third = third_corners(mesh, triangles);
  std::set<Edge> seen;
  std::vector<std::vector<int>> loops;
  for (const auto& [start, corner] : third) {
    if (third.contains({start.second, start.first}) || seen.contains(start)) continue;
    std::vector<int> loop;
    for (Edge edge = start; seen.insert(edge).second; edge = next_on_boundary(third, edge))
      loop.push_back(edge.first);
    loops.push_back(std::move(loop));
  }
  return loops;
}

/// The loop without the vertices in the middle of a straight side.
Loop corners_only(const Mesh& mesh, const std::vector<int>& loop, double reach) {
  Loop corners;
  for (const int v : loop) corners.push_back(mesh.vertices[v]);
  for (std::size_t i = 0; i < corners.size() && corners.size() > 3;) {
    const Vector3d& before = corners[(i + corners.size() - 1) % corners.size()];
    const Vector3d& after = corners[(i + 1) % corners.size()];
    const Vector3d chord = after - before, leg = corners[i] - before;
    const double length = chord.norm();
    if (length > 0 && leg.cross(chord).norm() <= reach * length && leg.dot(chord) > 0 &&
        leg.dot(chord) < chord.squaredNorm())
      corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i));
    else
      ++i;
  }
  return corners;
}

double signed_area(const Loop& loop, const Vector3d& normal) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 0; i < loop.size(); ++i)
    sum += (loop[i] - loop[0]).cross(loop[(i + 1) % loop.size()] - loop[0]);
  return sum.dot(normal) / 2;
}

}  // namespace

std::vector<Face> faces_of(const Mesh& mesh) {
  const double reach = 1e-9 * bounds_of(mesh).diagonal();
  std::vector<Face> faces(mesh.face_count);
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    faces[mesh.face_of_triangle[t]].triangles.push_back(t);
  for (Face& face : faces) {
    Vector3d sum = Vector3d::Zero(), weighted = Vector3d::Zero(), corners = Vector3d::Zero();
    double weights = 0;
    for (const int t : face.triangles) sum += area_vector(mesh, t);
    if (sum.norm() > 0) face.normal = sum.normalized();
    for (const int t : face.triangles) {
      const auto& [a, b, c] = mesh.triangles[t];
      const Vector3d middle = (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3;
      const double weight = area_vector(mesh, t).dot(face.normal);
      weighted += weight * middle;
      weights += weight;
      corners += middle;
    }
    face.area = weights / 2;
    face.centroid = weights > 0 ? Vector3d(weighted / weights)
                                : Vector3d(corners / static_cast<double>(face.triangles.size()));
    for (const std::vector<int>& loop : boundary_loops(mesh, face.triangles))
      face.loops.push_back(corners_only(mesh, loop, reach));
    std::stable_sort(face.loops.begin(), face.loops.end(), [&](const Loop& a, const Loop& b) {
      return signed_area(a, face.normal) > signed_area(b, face.normal);
    });
  }
  return faces;
}

double narrowest_place(const Mesh& mesh) {
  double narrowest = std::numeric_limits<double>::infinity();
  for (const Face& face : faces_of(mesh)) {
    std::vector<std::pair<Vector3d, Vector3d>> sides;
    for (const auto& loop : face.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) sides.emplace_back(loop[i], loop[(i + 1) % loop.size()]);
    for (const auto& [vertex, unused] : sides)
      for (const auto& [a, b] : sides) {
        if (vertex == a || vertex == b) continue;
        const Vector3d along = b - a;
        const double t = std::clamp(along.dot(vertex - a) / along.squaredNorm(), 0.0, 1.0);
        narrowest = std::min(narrowest, (vertex - a - t * along).norm());
      }
  }
  return narrowest;
}

}  // namespace limpet::simulation
