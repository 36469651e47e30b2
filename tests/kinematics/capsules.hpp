// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <limpet/model/view.hpp>
#include <vector>

/// What is inside capsules, and how far these go beyond what they hold.
namespace limpet::kinematics::testing {

inline double depth_in(const Eigen::Vector3d& p, const model::Capsule& capsule) {
  const Eigen::Vector3d along = capsule.b - capsule.a;
  const double length2 = along.squaredNorm();
  const double share = length2 > 0 ? std::clamp((p - capsule.a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return capsule.radius - (p - capsule.a - share * along).norm();
}

inline bool is_in(const Eigen::Vector3d& p, const model::Capsule& capsule) {
  return depth_in(p, capsule) >= 0;
}

inline bool is_in_any(const Eigen::Vector3d& p, const std::vector<model::Capsule>& capsules) {
  return std::any_of(capsules.begin(), capsules.end(), [&](const auto& one) { return is_in(p, one); });
}

/// How far a capsule goes beyond the hull of points in it: for convex bodies, one in the other, the largest
/// difference of how far they reach in any direction; here in 2,000.
inline double excess(const model::Capsule& capsule, const std::vector<Eigen::Vector3d>& points) {
  double most = 0;
  for (int i = 0; i < 2000; ++i) {  // a spiral over the ball
    const double z = 1 - (2 * i + 1) / 2000.0, angle = 2.399963229728653 * i;
    const double r = std::sqrt(1 - z * z);
    const Eigen::Vector3d to(r * std::cos(angle), r * std::sin(angle), z);
    double reach = -std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& p : points) reach = std::max(reach, to.dot(p));
    most = std::max(most, std::max(to.dot(capsule.a), to.dot(capsule.b)) + capsule.radius - reach);
  }
  return most;
}

}  // namespace limpet::kinematics::testing
