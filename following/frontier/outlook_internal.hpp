// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace limpet::following::internal {

/// A place where surface is expected that the model does not have yet.
struct Target {
  Eigen::Vector3d at;
  Eigen::Vector3d normal;  ///< the way the expected surface faces
  double weight = 1;       ///< what a reading there is worth
};

/// A part of an open edge, as the border of what is felt of its polygon's plane.
struct Border {
  Eigen::Vector3d from, to;
  Eigen::Vector3d outward;  ///< unit vector in the plane, away from what is felt
  Eigen::Vector3d normal;   ///< of the plane
  bool goes_on = false;     ///< surface is expected outside, in the plane
};

/// What is known of the surface near the control point, and expected.
struct Outlook {
  std::vector<Target> targets;
  std::vector<Border> borders;
  std::vector<Eigen::Vector3d> points;     ///< the point segments
  std::vector<Eigen::Vector3d> empty;      ///< places where surface was expected, and rays met none
  std::vector<Eigen::Vector3d> suspected;  ///< places up to which the surface may go on, to be kept off

  void clear() { targets.clear(), borders.clear(), points.clear(), empty.clear(), suspected.clear(); }
};

}  // namespace limpet::following::internal
