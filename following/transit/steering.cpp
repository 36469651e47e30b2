// Copyright the limpet authors. GPL-3.0-or-later.
#include "steering_internal.hpp"

#include <algorithm>

namespace limpet::following::internal {

using Eigen::Vector3d;

bool Steering::is_safe(const Vector3d& there) const {
  constexpr double kMargin = 1.2;  // δ − λ
  return clearance_.is_safe(view_, here_, there, kMargin * clearance_.least());
}

Vector3d Steering::towards(const Vector3d& there) const {
  const Vector3d way = there - here_;
  const Vector3d straight = shortened(way);
  const Vector3d bent = shortened(bent_off(straight));
  for (const Vector3d& motion : {straight, bent})
    if (is_safe(here_ + motion)) return motion;
  for (const Vector3d& motion : {straight, bent})
    if (clearance_.is_clear(view_, here_, here_ + motion)) return motion;
  const Vector3d round = way_round(there);
  return round.isZero() ? way_out() : round;
}

/// The clear step that leads nearest to `there`; zero when none leads nearer.
Vector3d Steering::way_round(const Vector3d& there) const {
  Vector3d best = Vector3d::Zero();
  double least = (there - here_).norm() - 0.1 * step_;
  for (std::size_t i = 0; i < posture_.robot().sensors.size(); ++i) {
    const Vector3d way = step_ * posture_.sensor(i).axis;
    const double left = (there - here_ - way).norm();
    if (left < least && clearance_.is_clear(view_, here_, here_ + way)) best = way, least = left;
  }
  return best;
}

/// No longer than the step.
Vector3d Steering::shortened(const Vector3d& motion) const {
  const double length = motion.norm();
  return length > step_ ? Vector3d(motion * (step_ / length)) : motion;
}

/// Without what leads towards the nearest surface, and away from it where it is near.
Vector3d Steering::bent_off(const Vector3d& motion) const {
  const double wanted = 1.5 * clearance_.least();
  const auto nearest = view_.nearest(here_, 2 * wanted);
  if (!nearest || nearest->distance == 0) return motion;
  const Vector3d away = (here_ - nearest->at) / nearest->distance;
  const Vector3d along = motion - std::min(0.0, motion.dot(away)) * away;
  return along + std::max(0.0, wanted - nearest->distance) * away;
}

/// The clear step that leads farthest from what is near.
Vector3d Steering::way_out() const {
  const double reach = 2 * clearance_.least();
  Vector3d best = Vector3d::Zero();
  double farthest = clearance_.at(view_, here_, reach);
  for (std::size_t i = 0; i < posture_.robot().sensors.size(); ++i)
    for (const double length : {step_, step_ / 4}) {
      const Vector3d way = length * posture_.sensor(i).axis;
      if (!clearance_.is_clear(view_, here_, here_ + way)) continue;
      const double distance = clearance_.at(view_, here_ + way, reach);
      if (distance > farthest) best = way, farthest = distance;
    }
  return best;
}

}  // namespace limpet::following::internal
