// Copyright the limpet authors. GPL-3.0-or-later.
#include "standing_internal.hpp"

#include <algorithm>
#include <cmath>

#include <limpet/geometry/predicates.hpp>
#include <limpet/geometry/search.hpp>

#include "heights_internal.hpp"

namespace limpet::model::internal {
namespace {

/// residual_limit() from the noise alone, without the tolerance.
double noise_limit(const Segment& polygon, const Eigen::Vector3d& p, double variance) {
  return 9 * (variance + polygon.fit.height_variance(p, polygon.data.variance()));
}

}  // namespace

double residual_limit(const Setting& setting, const Segment& polygon, const Eigen::Vector3d& p,
                      double variance) {
  const double by_noise = noise_limit(polygon, p, variance);
  // The plane of a young polygon is not known well enough to apply the tolerance.
  if (setting.rules().relief && polygon.young()) return by_noise;
  return std::max(by_noise, setting.parameters.tolerance * setting.parameters.tolerance);
}

Standing standing(const Setting& setting, const Segment& s, const Eigen::Vector3d& p,
                  const Eigen::Vector3d& axis, double squared_residual, double variance) {
  Standing result;
  const Scale scale = setting.scale_at(p);
  const double height = s.fit.height_of(p);
  if (height * height >= scale.lambda2 || axis.dot(s.fit.normal) > 0) return result;
  if (setting.rules().residual && squared_residual > residual_limit(setting, s, p, variance)) return result;
  const PolygonPart& part = *s.polygon;
  result.chart_point = geometry::round_to_grid(part.chart.project(p));
  result.outside = part.perimeter.locate(result.chart_point) == geometry::Polygon::Side::outside;
  result.distance2 = height * height;
  result.gap = scale.gap;
  if (setting.relief_kept() && s.mature_polygon() && squared_residual > noise_limit(s, p, variance)) {
    const auto local = local_residual(setting, s, p);
    if (!local || local->height * local->height > 9 * (variance + local->variance) + local->bend2)
      return result;
  }
  if (result.outside) {
    const auto nearest = geometry::nearest_perimeter_point(part.perimeter, result.chart_point, scale.gap);
    if (!nearest) return result;
    result.nearest = *nearest;
    result.distance2 += nearest->squared_distance * setting.step * setting.step;
  }
  result.near = result.distance2 < scale.lambda2;
  return result;
}

bool fits(const Setting& setting, const RawPoint& raw, const Segment& polygon) {
  const Eigen::Vector3d p = setting.world(raw.at);
  if (!polygon.indexed.contains(p)) return false;
  const double h = polygon.fit.height_of(p);
  return h * h <= residual_limit(setting, polygon, p, raw.variance) &&
         standing(setting, polygon, p, raw.axis, h * h, raw.variance).near;
}

bool lies_on_initial(const Setting& setting, const Segment& initial, const Eigen::Vector3d& p,
                     const Eigen::Vector3d& axis, double variance) {
  const double height = initial.fit.height_of(p), height2 = height * height;
  // The plane is given, so it has no variance of its own, unlike in residual_limit().
  const double limit2 = std::max(9 * variance, setting.parameters.tolerance * setting.parameters.tolerance);
  if (height2 > limit2 || height2 >= setting.scale_at(p).lambda2) return false;
  if (!faces_outside(initial.fit.normal, axis)) return false;
  const PolygonPart& part = *initial.polygon;
  return part.perimeter.locate(geometry::round_to_grid(part.chart.project(p))) !=
         geometry::Polygon::Side::outside;
}

}  // namespace limpet::model::internal
