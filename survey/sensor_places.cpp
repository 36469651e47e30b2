// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/survey/sensor_places.hpp>

#include <algorithm>

namespace limpet::survey {

using Eigen::Vector3d;

std::vector<Vector3d> sensor_places(const std::vector<model::SensorPoint>& readings, std::size_t most) {
  std::vector<Vector3d> places;
  for (double part = 1.0 / 30;; part *= 2) {
    places.clear();
    for (const model::SensorPoint& reading : readings) {
      if (!(reading.range > 0)) continue;
      const Vector3d from = reading.position - reading.range * reading.axis;
      const double within = part * reading.range;
      const bool is_known = std::any_of(places.begin(), places.end(), [&](const Vector3d& place) {
        return (place - from).squaredNorm() <= within * within;
      });
      if (is_known) continue;
      places.push_back(from);
      if (places.size() > most) break;
    }
    if (places.size() <= most) return places;
  }
}

}  // namespace limpet::survey
