// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/model/sensor_point.hpp>
#include <optional>
#include <vector>

namespace limpet::survey {

/// Depth cameras round depths to steps that grow with the range, so their readings lie in planes at right
/// angles to the optical axis. The scatter of a neighbourhood that spans only a few of these steps
/// understates the noise, and one that lies on a single step shows none at all.
struct RoundedDepths {
  Eigen::Vector3d axis =
      Eigen::Vector3d::Zero();  ///< unit vector along which depths are measured; zero: a coordinate axis
  double within =
      0;  ///< depths that differ by less are one, scan's unit: a scan that was turned has rounding errors
};

/// The axis along which the depths of a scan may be rounded that was turned after it was taken: the normal
/// that most of the neighbourhoods have in common which are flat to the last digit. None if it is one of the
/// coordinates' own, which need no telling, or if fewer than a fiftieth of `count` neighbourhoods are flat
/// and have it in common. `normals`: of those flat to within `within` (scan's unit), unit length, of either
/// sign.
std::optional<RoundedDepths> rounded_depths(const std::vector<Eigen::Vector3d>& normals, std::size_t count,
                                            double within);

/// What the depths of a neighbourhood say of its noise.
struct DepthNoise {
  enum class Kind {
    scatter,      ///< depths of all kinds: its thickness is its noise
    few_depths,   ///< its readings share few depths, at least two of which several have
    single_depth  ///< all have the same
  } kind = Kind::scatter;
  double noise = 0;  ///< standard deviation along the sensing axis, scan's unit
};

/// The standard deviation of a neighbourhood's readings along their sensing axis (unit length), which its
/// thickness along it, `apparent`, understates where depths are rounded: at least step/√12. Where the
/// neighbourhood shows a single depth this is `apparent`, and says nothing if the scan's depths are rounded.
/// Precondition: there is a point.
DepthNoise noise_of(const std::vector<model::SensorPoint>& points, const Eigen::Vector3d& axis,
                    double apparent, const RoundedDepths& rounded);

}  // namespace limpet::survey
