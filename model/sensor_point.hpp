// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>

namespace limpet::model {

/// A surface point found by one range sensor, in the world frame and the scan's unit. The sensing axis is a
/// unit vector that points into the surface (thesis §2.3).
struct SensorPoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  double range = 0;  ///< distance from the sensor; only where the noise grows with it
};

}  // namespace limpet::model
