// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/model/sensor_point.hpp>
#include <optional>
#include <vector>

namespace limpet::survey {

/// Depth cameras round depths to steps that grow with the range, so their readings lie in planes across the
/// optical axis. A neighbourhood of few steps looks flatter than its readings are exact, and one of a single
/// step exact.
struct RoundedDepths {
  Eigen::Vector3d axis =
      Eigen::Vector3d::Zero();  ///< unit, along which depths are; zero: that of the coordinates
  double within =
      0;  ///< depths that differ by less are the same, scan's unit: what turning a scan leaves of them
};

/// The axis along which the depths of a scan may be rounded that was turned after it was taken: what most of
/// the neighbourhoods that are flat to the last digit are across. None if it is one of the coordinates' own,
/// which need no telling, or if fewer than a fiftieth of `count` neighbourhoods are flat and have it in
/// common. `normals`: of those flat to within `within` (scan's unit), unit length, of either sign.
std::optional<RoundedDepths> rounded_depths(const std::vector<Eigen::Vector3d>& normals, std::size_t count,
                                            double within);

/// The standard deviation of a neighbourhood's readings along their sensing axis (unit length), which its
/// thickness along it, `apparent`, understates where depths are rounded: at least step/√12. None where the
/// neighbourhood shows a single step. Shapes: any number of points, one or more.
std::optional<double> noise_of(const std::vector<model::SensorPoint>& points, const Eigen::Vector3d& axis,
                               double apparent, const RoundedDepths& rounded);

}  // namespace limpet::survey
