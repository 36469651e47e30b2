// Copyright the limpet authors. GPL-3.0-or-later.
#include "new_ground_internal.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace limpet::following::internal {

using Eigen::Vector2d;
using Eigen::Vector3d;

NewGround::NewGround(double resolution, const Vector3d& origin, const Vector3d& normal)
    : lambda_(resolution), origin_(origin), u_(normal.unitOrthogonal()), v_(normal.cross(u_)) {}

void NewGround::add(const Border& border) {
  Vector2d from = flat(border.from), to = flat(border.to);
  const Vector2d outward(border.outward.dot(u_), border.outward.dot(v_)), way = to - from;
  if (way.y() * outward.x() - way.x() * outward.y() < 0) std::swap(from, to);
  const double length = (to - from).norm();
  if (length > 0) borders_.push_back({from, (to - from) / length, length, border.goes_on});
}

double NewGround::at_flat(const Vector2d& p) const {
  constexpr double kFelt = 0.45, kNew = 0.9, kFar = 3.8;  // λ
  const double equal2 = 1e-9 * lambda_ * lambda_;
  double least2 = kFar * kFar * lambda_ * lambda_, outside = 0;
  bool goes_on = false;
  for (const Line& border : borders_) {
    const Vector2d off = p - border.from;
    const double height = off.x() * border.along.y() - off.y() * border.along.x();
    const double along = off.dot(border.along);
    const double beyond = along - std::clamp(along, 0.0, border.length);
    const double d2 = height * height + beyond * beyond;
    // At a corner two borders are equally near: the one that is faced tells the side.
    const bool same = std::abs(d2 - least2) <= equal2;
    if (same ? std::abs(height) <= std::abs(outside) : d2 > least2) continue;
    least2 = d2, outside = height, goes_on = border.goes_on;
  }
  if (!goes_on || outside <= 0) return 0;
  for (const Vector2d& felt : felt_) least2 = std::min(least2, (p - felt).squaredNorm());
  // What is nearest tells: near a place that is empty, there is no surface either.
  for (const Vector2d& empty : empty_)
    if ((p - empty).squaredNorm() < 2 * least2) return 0;
  return std::clamp((std::sqrt(least2) / lambda_ - kFelt) / (kNew - kFelt), 0.0, 1.0);
}

}  // namespace limpet::following::internal
