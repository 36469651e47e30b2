// Copyright the limpet authors. GPL-3.0-or-later.
#include "empty_rays_internal.hpp"

#include <algorithm>
#include <limpet/following/free_rays.hpp>

namespace limpet::following::internal {

std::vector<Ray> free_rays(const Observation& seen, double resolution) {
  constexpr double kSurface = 0.6;  // λ
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < seen.posture.robot().sensors.size(); ++i) {
    const auto sensor = seen.posture.sensor(i);
    rays.push_back({sensor.position, sensor.axis,
                    free_range(sensor, seen.readings, resolution) - kSurface * resolution});
  }
  return rays;
}

void note_empty(const std::vector<Target>& targets, const std::vector<Ray>& rays, double resolution,
                PlaceMemory& memory) {
  const double near = kThrough * resolution;
  for (const Target& target : targets) {
    const auto goes_through = [&](const Ray& ray) {
      const auto crosses = crossing(ray, target.normal, target.normal.dot(target.at), kLeastThroughCosine);
      return crosses && (*crosses - target.at).squaredNorm() < near * near;
    };
    if (std::any_of(rays.begin(), rays.end(), goes_through)) memory.note_empty(target.at, target.normal);
  }
}

}  // namespace limpet::following::internal
