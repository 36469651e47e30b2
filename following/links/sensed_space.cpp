// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/following/free_rays.hpp>
#include <limpet/following/links/sensed_space.hpp>

#include <algorithm>
#include <cmath>

namespace limpet::following {

using Eigen::Vector3d;

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
    const model::Capsule capsule = kinematics::in_world(part, seen.posture);
    add_line(capsule.a, capsule.b);
  }
}

bool SensedSpace::holds(const model::Capsule& capsule) const {
  const int pieces = pieces_of(capsule.a, capsule.b);
  for (int i = 0; i <= pieces; ++i)
    if (!holds(capsule.a + (capsule.b - capsule.a) * (static_cast<double>(i) / pieces))) return false;
  return true;
}

}  // namespace limpet::following
