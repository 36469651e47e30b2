// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace limpet::following::internal {

/// The point of the line segment from a to b that is nearest to p.
inline Eigen::Vector3d nearest_on(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                  const Eigen::Vector3d& p) {
  const Eigen::Vector3d along = b - a;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return a + t * along;
}

}  // namespace limpet::following::internal
