// Copyright the limpet authors. GPL-3.0-or-later.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/squared_distance_3.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limpet/evaluation/nearest.hpp>
#include <limpet/evaluation/triangle_tree_internal.hpp>
#include <limpet/evaluation/true_surface.hpp>
#include <vector>

namespace limpet::evaluation {
namespace {

using Eigen::Vector3d;
using Plain = CGAL::Simple_cartesian<double>;  // distances need no decisions

Plain::Point_3 plain(const Vector3d& p) { return {p.x(), p.y(), p.z()}; }
Plain::Point_3 plain(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }

std::vector<Triangle3> triangles_of(const simulation::Mesh& mesh) {
  std::vector<Triangle3> triangles;
  for (const auto& [a, b, c] : mesh.triangles)
    triangles.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
  return triangles;
}

/// Where a ray that meets a triangle meets it: on its plane, or, of a ray within the plane, no farther than
/// its nearest corner.
double range_of(const Kernel::Triangle_3& triangle, const Vector3d& from, const Vector3d& direction) {
  Vector3d corner[3];
  for (int i = 0; i < 3; ++i) corner[i] = {triangle[i].x(), triangle[i].y(), triangle[i].z()};
  const Vector3d normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  const double approach = direction.dot(normal);
  if (approach != 0) return std::max(0.0, (corner[0] - from).dot(normal) / approach);
  double least = (corner[0] - from).dot(direction);
  for (const Vector3d& c : corner) least = std::min(least, (c - from).dot(direction));
  return std::max(0.0, least);
}

}  // namespace

struct TrueSurface::Inside {
  explicit Inside(const std::vector<Triangle3>& all) : nearest(all) {
    for (const Triangle3& t : all) {
      const Kernel::Triangle_3 triangle(point(t[0]), point(t[1]), point(t[2]));
      if (!triangle.is_degenerate()) triangles.push_back(triangle);
    }
    tree.insert(triangles.cbegin(), triangles.cend());
    tree.build();
  }

  NearestSurface nearest;
  ExactTriangles triangles;
  ExactTree tree;
};

TrueSurface::TrueSurface(const simulation::Mesh& mesh)
    : inside_(std::make_unique<Inside>(triangles_of(mesh))) {}
TrueSurface::~TrueSurface() = default;
TrueSurface::TrueSurface(TrueSurface&&) noexcept = default;
TrueSurface& TrueSurface::operator=(TrueSurface&&) noexcept = default;

double TrueSurface::distance(const Vector3d& place) const { return inside_->nearest.distance(place); }

bool TrueSurface::meets(const Vector3d& a, const Vector3d& b) const {
  if (a == b) return distance(a) == 0;
  return inside_->tree.do_intersect(Kernel::Segment_3(point(a), point(b)));
}

double TrueSurface::distance_along(const Vector3d& a, const Vector3d& b) const {
  const double of_ends = std::min(distance(a), distance(b));
  if (of_ends == 0 || a == b || inside_->triangles.empty()) return of_ends;
  if (meets(a, b)) return 0;
  return distance_of_edges(a, b, of_ends);
}

/// A way that meets no triangle is nearest to one at an end of the way or at an edge of the triangle.
double TrueSurface::distance_of_edges(const Vector3d& a, const Vector3d& b, double within) const {
  const Vector3d low = a.cwiseMin(b).array() - within, high = a.cwiseMax(b).array() + within;
  std::vector<ExactTriangles::const_iterator> near;
  inside_->tree.all_intersected_primitives(
      CGAL::Bbox_3(low.x(), low.y(), low.z(), high.x(), high.y(), high.z()), std::back_inserter(near));
  const Plain::Segment_3 way(plain(a), plain(b));
  double least2 = within * within;
  for (const auto& triangle : near)
    for (int i = 0; i < 3; ++i)
      least2 = std::min(least2, CGAL::squared_distance(
                                    way, Plain::Segment_3(plain((*triangle)[i]), plain((*triangle)[i + 1]))));
  return std::sqrt(least2);
}

bool TrueSurface::keeps(const Vector3d& a, const Vector3d& b, double least) const {
  const double from = distance(a);
  if (from < least) return false;
  const double to = distance(b);
  if (to < least) return false;
  // The distance changes by no more than the way between.
  if ((from + to - (b - a).norm()) / 2 >= least) return true;
  return distance_along(a, b) >= least;
}

std::optional<double> TrueSurface::first_crossing(const Vector3d& from, const Vector3d& direction) const {
  const Kernel::Ray_3 ray(point(from), Kernel::Vector_3(direction.x(), direction.y(), direction.z()));
  const auto met = inside_->tree.first_intersected_primitive(ray);
  if (!met) return std::nullopt;
  return range_of(**met, from, direction);
}

}  // namespace limpet::evaluation
