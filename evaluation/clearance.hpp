// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <limpet/evaluation/true_surface.hpp>
#include <span>

namespace limpet::evaluation {

/// How near a path came to the true surface. Lengths are in the scan's unit. Distances have no sign: a path
/// that stays inside a solid is not told from one outside; one that enters it collides.
struct PathClearance {
  double at_positions = std::numeric_limits<double>::infinity();  ///< smallest distance at a position
  double along = std::numeric_limits<double>::infinity();  ///< smallest at a position or on the way between
  std::size_t worst = 0;       ///< the position that the nearest step starts from, the first of equals
  std::size_t collisions = 0;  ///< steps whose straight way, with its ends, touches or crosses the surface
  double length = 0;           ///< of the path
};

/// Measures the path of a control point, straight from each position to the next. Distances are right up to
/// rounding, collisions are decided exactly for the positions as they are given. Infinite distances: there is
/// no position, or no surface.
PathClearance clearance_of(std::span<const Eigen::Vector3d> path, const TrueSurface& truth);

}  // namespace limpet::evaluation
