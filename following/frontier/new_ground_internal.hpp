// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "outlook_internal.hpp"

namespace limpet::following::internal {

/// How much a reading would add at a place of a plane: much where surface is expected and nothing is felt
/// within 0.9 λ. The surface is felt in fewest sets when most rays of each meet new ground; what they leave
/// between them is for targets.
///
/// With b, f and e the distances to the nearest border, felt and empty place, it is 0 unless the place is
/// outside of that border, the surface goes on there, b ≤ 3.8 λ, and e ≥ √2 min(b, f); then it rises from 0
/// where min(b, f) ≤ 0.45 λ to 1 from 0.9 λ on.
///
///  (1) Where a corner of two borders is nearest, the one whose line is farther off counts: a place is
///      outside exactly when it is outside of the polygon they bound;
///  (2) neither a rigid motion of all, nor the order of what is added, changes the answer, but where borders
///      differ in going on and are equally near and faced.
class NewGround {
 public:
  NewGround(double resolution, const Eigen::Vector3d& origin, const Eigen::Vector3d& normal);

  /// A border without length is left out.
  void add(const Border&);
  void add_felt(const Eigen::Vector3d& point) { felt_.push_back(flat(point)); }
  void add_empty(const Eigen::Vector3d& place) { empty_.push_back(flat(place)); }
  /// From 0 to 1, for a place in the plane; of other places the projection counts.
  double at(const Eigen::Vector3d& place) const { return at_flat(flat(place)); }
  double at_flat(const Eigen::Vector2d& flat) const;

  /// Coordinates in the plane, of a place or of a direction.
  Eigen::Vector2d flat(const Eigen::Vector3d& place) const { return flat_way(place - origin_); }
  Eigen::Vector2d flat_way(const Eigen::Vector3d& way) const { return {way.dot(u_), way.dot(v_)}; }

 private:
  struct Line {
    Eigen::Vector2d from, along;  ///< outward is on the right of it
    double length;
    bool goes_on;
  };

  double lambda_;
  Eigen::Vector3d origin_, u_, v_;
  std::vector<Line> borders_;
  std::vector<Eigen::Vector2d> felt_, empty_;
};

}  // namespace limpet::following::internal
