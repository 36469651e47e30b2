// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/evaluation/clearance.hpp>

#include <algorithm>

namespace limpet::evaluation {

PathClearance clearance_of(std::span<const Eigen::Vector3d> path, const TrueSurface& truth) {
  PathClearance result;
  for (const Eigen::Vector3d& place : path)
    result.at_positions = std::min(result.at_positions, truth.distance(place));
  result.along = path.size() == 1 ? result.at_positions : result.along;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    result.length += (path[i + 1] - path[i]).norm();
    result.collisions += truth.meets(path[i], path[i + 1]);
    const double distance = truth.distance_along(path[i], path[i + 1]);
    if (distance >= result.along) continue;
    result.along = distance;
    result.worst = i;
  }
  return result;
}

}  // namespace limpet::evaluation
