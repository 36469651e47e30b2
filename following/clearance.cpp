// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/following/clearance.hpp>
#include <limpet/following/nearest_on_internal.hpp>

#include <algorithm>
#include <cmath>

namespace limpet::following {
namespace {

using Eigen::Vector3d;

double squared_distance_to_way(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  return (internal::nearest_on(a, b, p) - p).squaredNorm();
}

}  // namespace

double Clearance::at(const model::View& view, const Vector3d& place, double reach) const {
  return along(view, place, place, reach);
}

double Clearance::along(const model::View& view, const Vector3d& a, const Vector3d& b, double reach) const {
  double least2 = reach * reach;
  for (const Vector3d& p : recent_.positions()) least2 = std::min(least2, squared_distance_to_way(p, a, b));
  const double least = std::sqrt(least2);
  const auto found = view.nearest(model::Capsule{a, b, 0}, least);
  return found ? std::min(found->distance, least) : least;
}

bool Clearance::keeps(const model::View& view, const Vector3d& from, const Vector3d& to,
                      double distance) const {
  if (along(view, from, to, distance) >= distance) return true;
  // From too near, every step must lead away: the way's nearest place is its start.
  const double start = at(view, from, distance);
  return start < distance && along(view, from, to, distance) >= start && at(view, to, distance) > start;
}

bool Clearance::is_clear(const model::View& view, const Vector3d& from, const Vector3d& to) const {
  return keeps(view, from, to, least_);
}

bool Clearance::is_safe(const model::View& view, const Vector3d& from, const Vector3d& to,
                        double distance) const {
  const double distance2 = distance * distance;
  for (const Vector3d& p : suspected_) {
    const double on_way2 = squared_distance_to_way(p, from, to);
    if (on_way2 < distance2 && on_way2 < (from - p).squaredNorm() * (1 - 1e-9)) return false;
  }
  return keeps(view, from, to, distance);
}

Vector3d Clearance::shortened(const model::View& view, const Vector3d& from, Vector3d motion) const {
  constexpr int kHalvings = 6;
  for (int i = 0; i <= kHalvings; ++i, motion /= 2)
    if (is_clear(view, from, from + motion)) return motion;
  return Vector3d::Zero();
}

}  // namespace limpet::following
