// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/following/free_rays.hpp>
#include <limpet/following/links/sensed_space.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limpet::following {

using Eigen::Vector3d;

namespace {

/// Calls f(from, to) for lines along a capsule: its axis, and if it is wider than a cell lines on its surface
/// that are no more than about a cell apart, in its ends' caps, too.
template <class F>
void for_each_line(const model::Capsule& capsule, double cell, F&& f) {
  const double length = (capsule.b - capsule.a).norm();
  const Vector3d along = length > 0 ? Vector3d((capsule.b - capsule.a) / length) : Vector3d::UnitZ();
  const Vector3d u = along.unitOrthogonal(), v = along.cross(u), cap = capsule.radius * along;
  f(capsule.a - cap, capsule.b + cap);
  if (2 * capsule.radius < cell) return;
  const int around = std::max(4, static_cast<int>(std::ceil(2 * std::numbers::pi * capsule.radius / cell)));
  for (int i = 0; i < around; ++i) {
    const double angle = 2 * std::numbers::pi * i / around;
    const Vector3d off = capsule.radius * (std::cos(angle) * u + std::sin(angle) * v);
    f(capsule.a + off, capsule.b + off);
    f(capsule.a + (off - cap) / std::numbers::sqrt2, capsule.b + (off + cap) / std::numbers::sqrt2);
  }
}

}  // namespace

/// 21 bits of each index: places 2^20 cells away and more share cells.
std::uint64_t SensedSpace::key_of(const Vector3d& place) const {
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto index = static_cast<std::int64_t>(std::floor(place[axis] / cell_));
    key = key << 21 | (static_cast<std::uint64_t>(index) & ((std::uint64_t{1} << 21) - 1));
  }
  return key;
}

int SensedSpace::pieces_of(const Vector3d& from, const Vector3d& to) const {
  return 1 + static_cast<int>((to - from).norm() / cell_);
}

/// Every place half a cell from the next: a line that cuts off less than that of a cell may miss it. Twice as
/// many places as are asked about, so that what was added is held.
void SensedSpace::add_line(const Vector3d& from, const Vector3d& to) {
  const int pieces = 2 * pieces_of(from, to);
  for (int i = 0; i <= pieces; ++i)
    cells_.insert(key_of(from + (to - from) * (static_cast<double>(i) / pieces)));
}

void SensedSpace::add(const Observation& seen, std::span<const kinematics::BodyPart> body, double beside) {
  for (std::size_t i = 0; i < seen.posture.robot().sensors.size(); ++i) {
    const auto sensor = seen.posture.sensor(i);
    const double free = free_range(sensor, seen.readings, beside);
    add_line(sensor.position, sensor.position + free * sensor.axis);
  }
  for (std::size_t i = 0; i < seen.posture.robot().switches.size(); ++i) {
    if (std::binary_search(seen.seeing.begin(), seen.seeing.end(), i)) continue;
    const auto s = seen.posture.proximity_switch(i);
    add_line(s.position, s.position + s.range * s.axis);
  }
  for (const kinematics::BodyPart& part : body) {
    for_each_line(kinematics::in_world(part, seen.posture), cell_,
                  [&](const Vector3d& from, const Vector3d& to) { add_line(from, to); });
  }
}

bool SensedSpace::holds_line(const Vector3d& from, const Vector3d& to) const {
  const int pieces = pieces_of(from, to);
  for (int i = 0; i <= pieces; ++i)
    if (!holds(from + (to - from) * (static_cast<double>(i) / pieces))) return false;
  return true;
}

bool SensedSpace::holds(const model::Capsule& capsule) const {
  bool all = true;
  for_each_line(capsule, cell_,
                [&](const Vector3d& from, const Vector3d& to) { all = all && holds_line(from, to); });
  return all;
}

}  // namespace limpet::following
