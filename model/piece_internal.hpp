// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>

namespace limpet::model::internal {

/// A line segment between two points in space.
struct Piece {
  Eigen::Vector3d a, b;

  /// The point at a parameter, from 0 at a to 1 at b.
  Eigen::Vector3d at(double t) const { return t == 1 ? b : Eigen::Vector3d(a + t * (b - a)); }
  /// The parameter of the point nearest to p.
  double nearest(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d along = b - a;
    const double length2 = along.dot(along);
    return length2 > 0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  }
};

}  // namespace limpet::model::internal
