// Copyright the limpet authors. GPL-3.0-or-later.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "edges_internal.hpp"

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;

/// r of thesis (6): how much the control point is drawn towards the follow edge.
double attraction(double distance, const Parameters& p) {
  return std::clamp((distance - p.follow_distance) / (p.stray_limit - p.follow_distance), 0.0, 1.0);
}

}  // namespace

std::size_t nearest_edge(const std::vector<model::View::Edge>& edges, const Vector3d& p) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const double d = (nearest_on(edges[i], p) - p).squaredNorm();
    if (d < least) least = d, best = i;
  }
  return best;
}

Vector3d towards_and_along(const Vector3d& from, const Vector3d& to, const Vector3d& control_point,
                           const Parameters& p) {
  const Vector3d towards = nearest_on(from, to, control_point) - control_point, along = to - from;
  const double r = attraction(towards.norm(), p);
  return r * towards.normalized() + (1 - r) * along.normalized();
}

std::optional<Vector3d> towards_outside(const model::View& view, model::SegmentId id,
                                        const Vector3d& control_point) {
  const auto segment = view.segment(id);
  if (!segment || segment->edges == 0 || segment->plane.height_of(control_point) >= 0) return std::nullopt;
  std::vector<model::View::Edge> edges;
  view.edges(id, edges);
  const model::View::Edge& edge = edges[nearest_edge(edges, control_point)];
  return Vector3d((control_point - nearest_on(edge, control_point)).cross(edge.to - edge.from));
}

}  // namespace limpet::following::internal
