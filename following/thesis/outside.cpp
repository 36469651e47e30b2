// Copyright the limpet authors. GPL-3.0-or-later.
#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "edges_internal.hpp"
#include "outside_internal.hpp"

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;
using model::View;

/// e × n: along the segment's plane, away from its inside.
Vector3d outward_vector(const View& view, const View::Edge& edge) {
  return (edge.to - edge.from).cross(view.segment(edge.segment)->plane.normal).normalized();
}

struct Piece {
  Vector3d a, b;
};

/// The part of a piece where a linear function, with values at its ends, is at least `least`.
std::optional<Piece> clipped(const Piece& piece, double at_a, double at_b, double least) {
  if (at_a < least && at_b < least) return std::nullopt;
  Piece part = piece;
  const Vector3d cut = piece.a + (least - at_a) / (at_b - at_a) * (piece.b - piece.a);
  if (at_a < least) part.a = cut;
  if (at_b < least) part.b = cut;
  return part;
}

}  // namespace

Outside::Outside(const View& view, const View::Edge& edge, const Vector3d& slice_vector)
    : view_(view), edge_(edge), vector_(slice_vector), out_(outward_vector(view, edge)) {
  std::tie(first_, last_) = std::minmax(vector_.dot(edge.from), vector_.dot(edge.to));
}

bool Outside::contains(const View::Nearest& found) const {
  if (found.segment != edge_.segment) return true;
  // Points of the edge itself are not outside it, whatever rounding says.
  if (found.edge == edge_.id) return false;
  const double place = vector_.dot(found.at);
  const double rounding = 1e-9 * length(edge_);
  return place > first_ && place < last_ && outwards(found.at) > rounding;
}

bool Outside::is_near(const Vector3d& current_point, double reach) const {
  model::Which others;
  others.but = edge_.segment;
  return view_.nearest(current_point, reach, others) || own_is_near(current_point, reach);
}

bool Outside::own_is_near(const Vector3d& current_point, double reach) const {
  // The nearest such point of the segment lies on its boundary, because the edge itself does.
  std::vector<View::Edge> edges;
  view_.edges(edge_.segment, edges);
  const double rounding = 1e-9 * reach;
  return std::any_of(edges.begin(), edges.end(), [&](const View::Edge& e) {
    if (e.id == edge_.id || distance(e, current_point) >= reach) return false;
    auto cut = [&](const std::optional<Piece>& p, auto&& value, double least) {
      return p ? clipped(*p, value(p->a), value(p->b), least) : std::nullopt;
    };
    std::optional<Piece> part = Piece{e.from, e.to};
    part = cut(
        part, [&](const Vector3d& p) { return outwards(p); }, rounding);
    part = cut(
        part, [&](const Vector3d& p) { return vector_.dot(p); }, first_ + rounding);
    part = cut(
        part, [&](const Vector3d& p) { return -vector_.dot(p); }, rounding - last_);
    return part && (nearest_on(part->a, part->b, current_point) - current_point).norm() < reach;
  });
}

}  // namespace limpet::following::internal
