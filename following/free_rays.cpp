// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/following/free_rays.hpp>

namespace limpet::following {

double free_range(const kinematics::Posture::Sensor& sensor, std::span<const model::SensorPoint> set,
                  double beside) {
  constexpr double kSame = 1e-9;
  double free = sensor.range, nearest2 = beside * beside;
  for (const model::SensorPoint& reading : set) {
    if ((reading.axis - sensor.axis).squaredNorm() > kSame) continue;
    const Eigen::Vector3d on_axis = sensor.position + reading.range * sensor.axis;
    const double off2 = (reading.position - on_axis).squaredNorm();
    if (off2 < nearest2) nearest2 = off2, free = reading.range;
  }
  return free;
}

}  // namespace limpet::following
