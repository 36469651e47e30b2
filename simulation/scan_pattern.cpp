// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/simulation/scan_pattern.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace limpet::simulation {

using Eigen::Vector3d;

/// Rays tried in one round of looking for a pitch.
constexpr double kMaxRays = 4e6;

void ScanPattern::sweep(double pitch, const Take& take) const {
  send(pitch, [&](const Vector3d& source, const Vector3d& direction) {
    if (const auto hit = caster_.first_hit(source, direction)) take(*hit, direction);
  });
}

std::int64_t ScanPattern::count(double pitch) const {
  std::int64_t hits = 0;
  sweep(pitch, [&hits](const RayCaster::Hit&, const Vector3d&) { ++hits; });
  return hits;
}

double ScanPattern::pitch_for(std::int64_t points) const {
  // Hits go with 1/pitch². Finding the pitch for few points is enough: for many it follows by scaling.
  const double wanted = static_cast<double>(std::min<std::int64_t>(points, 100'000));
  double pitch = std::sqrt(extent() / wanted), best = pitch, best_error = std::numeric_limits<double>::max();
  for (int round = 0; round < 10 && best_error > 0.005; ++round) {
    const double hits = static_cast<double>(count(pitch));
    const double error = std::abs(hits / wanted - 1);
    if (hits > 0 && error < best_error) {
      best = pitch;
      best_error = error;
    }
    pitch *= std::clamp(std::sqrt(hits / wanted), 0.25, 4.0);
    if (extent() / (pitch * pitch) > kMaxRays) break;  // hardly anything of the surface, or nothing, is seen
  }
  if (best_error == std::numeric_limits<double>::max()) throw MeshError("no viewpoint sees the surface");
  return best * std::sqrt(wanted / static_cast<double>(points));
}

}  // namespace limpet::simulation
