// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>

#include <limpet/model/parameters.hpp>

#include "moments_internal.hpp"
#include "spatial_index_internal.hpp"

namespace limpet::model::internal {

/// λ in a place.
struct Scale {
  double lambda = 0;   ///< scan's unit
  double lambda2 = 0;  ///< λ²
  double gap = 0;      ///< λ in grid steps
};

/// The parameters of a model and the quantities that follow from them. Constant for the life of the model.
struct Setting {
  /// Throws std::invalid_argument when a parameter is out of range.
  explicit Setting(const Parameters&);

  Parameters parameters;
  Scale least;                          ///< where λ is least: everywhere, unless it grows with the range
  double step = 0;                      ///< grid step, scan's unit
  double rounding = 0;                  ///< variance of grid and input rounding together, scan's unit squared
  double sin_angle = 0, cos_angle = 0;  ///< of μ
  double cos_half_angle = 0;            ///< of μ/2

  bool resolution_grows() const { return parameters.resolution_per_range > 0; }
  Scale scale_at(const Eigen::Vector3d& place) const { return resolution_grows() ? grown_at(place) : least; }
  /// Where λ is largest among places no farther than this from one.
  Scale largest_scale(const Eigen::Vector3d& place, double within) const {
    return resolution_grows() ? grown_at(place, within) : least;
  }
  Scale largest_scale(const Box3& box) const {
    return resolution_grows() ? grown_at(box.center(), box.diagonal().norm() / 2) : least;
  }
  Scale scale_of(double lambda) const { return {lambda, lambda * lambda, lambda / step}; }
  const Rules& rules() const { return parameters.rules; }
  Eigen::Vector3d world(const GridPoint& p) const {
    return step *
           Eigen::Vector3d(static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]));
  }
  /// Variance about its plane of a point sensed from a distance of `range`; scan's unit (squared).
  double variance_at(double range) const {
    const Parameters& p = parameters;
    const double sigma = p.noise + (p.noise_per_range + p.noise_per_range2 * range) * range;
    return sigma * sigma + rounding;
  }
  bool noise_grows() const { return parameters.noise_per_range > 0 || parameters.noise_per_range2 > 0; }
  /// Are height maps kept? Only where points may lie farther off their plane than the noise explains.
  bool relief_kept() const { return rules().relief && parameters.tolerance > 0; }

 private:
  Scale grown_at(const Eigen::Vector3d& place, double within = 0) const;
};

}  // namespace limpet::model::internal
