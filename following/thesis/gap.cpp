// Copyright the limpet authors. GPL-3.0-or-later.
#include <Eigen/Geometry>
#include <cmath>

#include "gap_internal.hpp"

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;
using model::View;

/// Where, from 0 at a to 1 at b, the way from a to b crosses an edge in a plane of normal n; 1 if nowhere.
double crossing(const Vector3d& a, const Vector3d& b, const View::Edge& edge, const Vector3d& n) {
  const Vector3d way = b - a, along = edge.to - edge.from, between = edge.from - a;
  const double area = n.dot(way.cross(along));
  if (area == 0) return 1;
  const double on_way = n.dot(between.cross(along)) / area, on_edge = n.dot(between.cross(way)) / area;
  // A way that begins on the perimeter leaves it there, and has yet to meet it.
  constexpr double kLeft = 1e-6;
  return on_way > kLeft && on_way < 1 && on_edge >= 0 && on_edge <= 1 ? on_way : 1;
}

}  // namespace

Vector3d gap_point(const View& view, const Vector3d& current_point, const View::Nearest& closest) {
  const auto segment = view.segment(closest.segment);
  if (!segment || segment->kind == View::Kind::point) return closest.at;
  const Vector3d& normal = segment->plane.normal;
  const Vector3d projection = current_point - segment->plane.height_of(current_point) * normal;
  std::vector<View::Edge> edges;
  view.edges(closest.segment, edges);
  double first = 1;
  for (const View::Edge& edge : edges)
    first = std::min(first, crossing(projection, closest.at, edge, normal));
  return projection + first * (closest.at - projection);
}

std::vector<Vector3d> target_points(const Vector3d& gap_point, const Vector3d& current_point,
                                    double spacing) {
  const Vector3d gap = current_point - gap_point;
  const double length = gap.norm();
  std::vector<Vector3d> targets{gap_point};
  for (int i = 1; i * spacing <= length; ++i) targets.push_back(gap_point + i * spacing / length * gap);
  return targets;
}

}  // namespace limpet::following::internal
