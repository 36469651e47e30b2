// Copyright the limpet authors. GPL-3.0-or-later.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limpet/evaluation/flat_polygon_internal.hpp>

namespace limpet::evaluation {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

double across(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

double turn(const Vector2d& a, const Vector2d& b) { return std::atan2(across(a, b), a.dot(b)); }

/// Signed area of the triangle (0, a, b) within the disc of this radius about 0.
double triangle_in_disc(const Vector2d& a, const Vector2d& b, double radius) {
  const Vector2d along = b - a;
  const double length2 = along.squaredNorm(), r2 = radius * radius;
  if (length2 == 0) return 0;
  const double middle = -a.dot(along) / length2;  // where the edge is nearest
  const double half2 = middle * middle - (a.squaredNorm() - r2) / length2;
  const double half = half2 > 0 ? std::sqrt(half2) : 0;
  const double enters = std::max(middle - half, 0.0), leaves = std::min(middle + half, 1.0);
  if (!(enters < leaves)) return r2 / 2 * turn(a, b);
  const Vector2d in = a + enters * along, out = a + leaves * along;
  double area = across(in, out) / 2;
  if (enters > 0) area += r2 / 2 * turn(a, in);
  if (leaves < 1) area += r2 / 2 * turn(out, b);
  return area;
}

}  // namespace

FlatPolygon::FlatPolygon(const PlanarFace& face)
    : origin_(face.cycles.empty() || face.cycles.front().empty() ? Vector3d::Zero()
                                                                 : face.cycles.front().front()),
      u_(face.normal.unitOrthogonal()),
      v_(face.normal.cross(u_)),
      normal_(face.normal) {
  for (const auto& cycle : face.cycles) {
    auto& flattened = cycles_.emplace_back();
    for (const Vector3d& vertex : cycle) flattened.push_back(flat(vertex));
  }
}

template <class Visit>
void FlatPolygon::each_edge(const Visit& visit) const {
  for (const auto& cycle : cycles_)
    for (std::size_t i = 0; i < cycle.size(); ++i) visit(cycle[i], cycle[(i + 1) % cycle.size()]);
}

Vector2d FlatPolygon::flat(const Vector3d& world) const {
  return {(world - origin_).dot(u_), (world - origin_).dot(v_)};
}

Vector3d FlatPolygon::raised(const Vector2d& place) const {
  return origin_ + place.x() * u_ + place.y() * v_;
}

bool FlatPolygon::inside(const Vector2d& place) const {
  bool odd = false;
  each_edge([&](const Vector2d& a, const Vector2d& b) {
    if ((a.y() > place.y()) == (b.y() > place.y())) return;
    const double left = across(b - a, place - a);
    if ((left > 0) == (b.y() > a.y())) odd = !odd;
  });
  return odd;
}

double FlatPolygon::area_within(const Vector2d& centre, double radius) const {
  double area = 0;
  each_edge([&](const Vector2d& a, const Vector2d& b) {
    area += triangle_in_disc(a - centre, b - centre, radius);
  });
  return std::max(area, 0.0);
}

}  // namespace limpet::evaluation
