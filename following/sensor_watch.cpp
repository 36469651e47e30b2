// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/following/sensor_watch.hpp>

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

namespace limpet::following {

using Eigen::Vector3d;

SensorWatch::SensorWatch(double resolution, std::size_t sensors)
    : least_volume_(1e-3 * resolution * resolution * resolution), records_(sensors) {
  if (!(resolution > 0)) throw std::invalid_argument("the resolution λ must be positive");
}

bool SensorWatch::is_stuck(std::size_t sensor, const Vector3d& position, std::optional<double> distance) {
  constexpr int kOffPlane = 16;
  Record& record = records_[sensor];
  if (record.stuck) return true;
  if (distance != record.distance) record = {distance, {}, 0, false};
  if (!distance) return false;
  auto& p = record.places;
  if (p.size() == 4) p.erase(p.begin());
  p.push_back(position);
  if (p.size() == 4 && std::abs((p[1] - p[0]).cross(p[2] - p[0]).dot(p[3] - p[0])) > least_volume_)
    ++record.off_plane;
  return record.stuck = record.off_plane >= kOffPlane;
}

std::vector<std::size_t> SensorWatch::stuck() const {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < records_.size(); ++i)
    if (records_[i].stuck) result.push_back(i);
  return result;
}

}  // namespace limpet::following
