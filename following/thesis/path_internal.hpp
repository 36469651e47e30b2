// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <set>
#include <vector>

#include <limpet/model/view.hpp>

namespace limpet::following::internal {

/// A way over the model to a segment (thesis §3.4.1).
struct Path {
  struct Leg {
    geometry::EdgeId edge;     ///< none: a hop over the surface or the gap between two perimeters
    Eigen::Vector3d from, to;  ///< in the direction of the path, when it was found
    bool forwards = true;      ///< the edge runs in the direction of the path
  };
  std::vector<Leg> legs;
  model::SegmentId goal;  ///< the last leg is one of its edges
};

/// The shortest path over the edges of the model's polygons, from the edge nearest to `start` to one of the
/// `goals` (ascending). Perimeters are joined by their shared edges; where these do not lead to a goal, as to
/// the rim of a hole, or to a surface that is not joined yet, the path hops between the nearest vertices of
/// what is not joined; but through the body, between points that are both behind the other's
/// polygon by more than `rim` (scan's unit), only where there is no other way. Edges that are barred are not
/// used. Nothing when there is no such path.
std::optional<Path> shortest_path(const model::View&, const Eigen::Vector3d& start,
                                  const std::vector<model::SegmentId>& goals,
                                  const std::set<geometry::EdgeId>& barred, double rim);

}  // namespace limpet::following::internal
