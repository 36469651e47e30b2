// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>

namespace limpet::model {

/// A surface point found by one range sensor, in the world frame and the scan's unit. The sensing axis points
/// into the surface (thesis §2.3); Model::update() scales it to a unit vector.
struct SensorPoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  double range = 0;  ///< distance from the sensor, for noise that grows with it
};

}  // namespace limpet::model
