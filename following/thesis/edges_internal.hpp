// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include <limpet/following/nearest_on_internal.hpp>
#include <limpet/following/parameters.hpp>
#include <limpet/model/view.hpp>

namespace limpet::following::internal {

inline Eigen::Vector3d nearest_on(const model::View::Edge& e, const Eigen::Vector3d& p) {
  return nearest_on(e.from, e.to, p);
}
inline double distance(const model::View::Edge& e, const Eigen::Vector3d& p) {
  return (nearest_on(e, p) - p).norm();
}
inline double length(const model::View::Edge& e) { return (e.to - e.from).norm(); }

/// Index of the edge nearest to p; the first of several. Precondition: there is one.
std::size_t nearest_edge(const std::vector<model::View::Edge>&, const Eigen::Vector3d& p);

/// The direction towards and along a follow edge (thesis (6), Figure 29a): parallel to it within δ, straight
/// towards it from ρ on, and a mixture between.
Eigen::Vector3d towards_and_along(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                  const Eigen::Vector3d& control_point, const Parameters&);

/// If the control point is inside a segment's plane, the direction round its closest edge to the outside
/// (thesis §3.4.1, Figure 29b): the cross product of the vector from the edge to the control point with the
/// edge's own, which is anticlockwise. Nothing when it is outside, or the segment is no polygon.
std::optional<Eigen::Vector3d> towards_outside(const model::View&, model::SegmentId,
                                               const Eigen::Vector3d& control_point);

}  // namespace limpet::following::internal
