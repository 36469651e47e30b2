// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <functional>
#include <limpet/model/sensor_point.hpp>
#include <limpet/survey/noise_law.hpp>
#include <limpet/survey/resolution_law.hpp>
#include <limpet/survey/sample.hpp>
#include <vector>

namespace limpet::survey {

/// What a scan tells about itself. A number is zero where the scan does not tell it, as where there are too
/// few points or all of them are in one place. Where points have exact copies (see Sample), each place is one
/// point: a copy tells nothing of the surface.
struct Estimate {
  double area_per_point = 0;  ///< mean area of the surface for each point, square of the scan's unit
  double sparse_area = 0;     ///< the same where the scan is sparse: 95 % of the surface has less
  NoiseLaw noise;             ///< standard deviation of a reading along its axis
  double curvature = 0;       ///< see surface_curvature(); one over the scan's unit
  double near_range = 0;      ///< 95 % of the points are farther from the sensor, scan's unit; 0: not known
  double far_range = 0;       ///< 5 % of the points are farther
  /// The same of the length √(area for five points) over the distance to the nearest sensor, a pure number:
  /// what λ would grow by. Here surfaces seen at a grazing angle count, too. 0: ranges are not known.
  double sparse_per_range = 0;
  std::vector<Eigen::Vector3d> sensors;  ///< where they stood (sensor_places()), at most model::kMostSensors
  std::int64_t points = 0;               ///< points that were looked at, copies too
};

using Take = std::function<void(const model::SensorPoint&)>;

/// Estimates from the points that `pass` hands out; it is called twice and hands out the same both times.
Estimate estimate(const std::function<void(const Take&)>& pass);

/// The same from a sample alone, for a stream that passes only once. The estimate is coarser: of a stream
/// larger than the sample, it sees no two points that are nearer than those of the sample, nor does it know
/// which noise or how many points there are at that scale; and the number of places of a stream with copies
/// is known to a hundredth only.
Estimate estimate(const Sample& sample);

/// What a linear resolution λ has to be at least, scan's unit, for each thing that asks for it.
struct ResolutionBounds {
  double density = 0;  ///< for about five points per λ²
  double sparse_parts =
      0;             ///< for three points per λ² where the scan is sparse; at most a third above `density`
  double noise = 0;  ///< ten times the noise where it is least, and five times where it is greatest
  double largest() const;
};

/// Precondition: the estimate's area_per_point is known. Below the bound by noise nothing is wide enough to
/// tell a plane's normal.
ResolutionBounds resolution_bounds(const Estimate& estimate, const NoiseLaw& noise);

/// λ that suits the scan: the largest of these; or one that grows with the range, where far surfaces have so
/// few points that they ask for half as much again.
ResolutionLaw suitable_resolution(const Estimate& estimate, const NoiseLaw& noise);

/// The noise to model the scan with at this λ: facets of a curved surface are to be some λ wide, or they find
/// no neighbours; so a reading is off from its facet by the noise and by how far the surface turns away from
/// it, together at most λ/15, a third of the tolerance (or the noise, where that is more).
NoiseLaw facet_noise(const Estimate& estimate, const NoiseLaw& noise, double resolution);

/// How many points there are to λ²: as a mean; where λ grows with the range, where the scan is sparse.
/// Infinite or none where the estimate does not tell.
double points_to_square(const Estimate& estimate, const ResolutionLaw& resolution);

/// How far from its plane a surface may be: three times the noise, taken where it is greatest, or λ/5.
double suitable_tolerance(double noise, double resolution);

}  // namespace limpet::survey
