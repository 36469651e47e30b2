// Copyright the limpet authors. GPL-3.0-or-later.
#include "setting_internal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "series_internal.hpp"

namespace limpet::model::internal {
namespace {

void require_parameter(bool good, const char* what) {
  if (!good) throw std::invalid_argument(what);
}

}  // namespace

Setting::Setting(const Parameters& p) : parameters(p) {
  const auto finite = [](double x) { return std::isfinite(x); };
  require_parameter(finite(p.resolution) && p.resolution > 0,
                    "the linear resolution must be a length greater than 0");
  require_parameter(finite(p.angle_rad) && p.angle_rad > 0 && p.angle_rad < 1.5707,
                    "the angular resolution must lie between 0 and 90 degrees");
  require_parameter(finite(p.noise) && p.noise >= 0, "the noise must be a length of 0 or more");
  require_parameter(finite(p.noise_per_range) && p.noise_per_range >= 0 && finite(p.noise_per_range2) &&
                        p.noise_per_range2 >= 0,
                    "what the noise grows by with the range must be 0 or more");
  require_parameter(finite(p.tolerance) && p.tolerance >= 0, "the tolerance must be a length of 0 or more");
  require_parameter(finite(p.input_quantum) && p.input_quantum >= 0,
                    "the input quantum must be a length of 0 or more");
  require_parameter(p.redundancy_count >= 0 && p.redundancy_ratio >= 0,
                    "the redundancy thresholds ψ and φ must be 0 or more");
  require_parameter(p.outlier_patience >= 0,
                    "the patience with outliers must be a number of sensor points, 0 or more");
  require_parameter(p.resolution > 1e-150 && p.resolution < 1e150, "the linear resolution is out of range");
  require_parameter(p.resolution_per_range >= 0 && p.resolution_per_range <= kMostResolutionGrowth,
                    "what the resolution grows by with the range must be 0 to 0.25");
  require_parameter(p.resolution_per_range == 0 || (!p.sensors.empty() && p.sensors.size() <= kMostSensors),
                    "a resolution that grows with the range needs the places of 1 to 64 sensors");
  for (const Eigen::Vector3d& at : p.sensors)
    require_parameter(at.allFinite(), "a sensor stands nowhere: its place is not finite");
  step = geometry::grid_step_for(p.resolution);
  least = scale_of(p.resolution);
  rounding = step * step + p.input_quantum * p.input_quantum;
  cos_angle = cosine(p.angle_rad);
  cos_half_angle = cosine(p.angle_rad / 2);
  sin_angle = std::sqrt(1 - cos_angle * cos_angle);
}

Scale Setting::grown_at(const Eigen::Vector3d& place, double within) const {
  double range2 = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& sensor : parameters.sensors)
    range2 = std::min(range2, (place - sensor).squaredNorm());
  return scale_of(parameters.resolution + parameters.resolution_per_range * (std::sqrt(range2) + within));
}

}  // namespace limpet::model::internal
