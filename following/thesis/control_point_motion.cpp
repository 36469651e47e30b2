// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/following/thesis/control_point_motion.hpp>

#include <algorithm>
#include <cmath>

namespace limpet::following {
namespace {

using Eigen::Vector3d;

/// Below this part of its length, what remains of a vector after projection is rounding.
constexpr double kNothing = 1e-9;

}  // namespace

Vector3d control_point_motion(const ClosestPoint& closest, double follow_distance, double step,
                              const Vector3d& along) {
  const double sigma = std::min(step, closest.distance);
  const double corrective = std::clamp(follow_distance - closest.distance, -sigma, sigma);
  const Vector3d perpendicular = along - along.dot(closest.away) * closest.away;
  const double length = perpendicular.norm();
  if (length <= kNothing * along.norm()) return corrective * closest.away;
  const double rest = std::sqrt(std::max(0.0, sigma * sigma - corrective * corrective));
  return corrective * closest.away + rest / length * perpendicular;
}

}  // namespace limpet::following
