// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>

namespace limpet::drawing {

/// Where the world is in a panel.
struct Placing {
  Eigen::Matrix3d axes;    ///< of the panel, its rows: right, down, away from the viewer; world
  Eigen::Vector3d middle;  ///< world; is at `centre`
  Eigen::Vector3d centre;  ///< pixels, with depth
  double scale = 1;        ///< pixels to a unit
  Eigen::Vector3d operator()(const Eigen::Vector3d& p) const {
    return centre + scale * (axes * (p - middle));
  }
};

/// Where the light comes from, in a panel's axes: from the upper left behind the viewer.
inline Eigen::Vector3d light_from() { return Eigen::Vector3d(-0.40, -0.62, -0.68).normalized(); }

}  // namespace limpet::drawing
