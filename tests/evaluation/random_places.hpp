// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/survey/random.hpp>

namespace limpet::evaluation {

/// A place in a cube, each coordinate within these.
inline Eigen::Vector3d anywhere(survey::Random& random, double low, double high) {
  Eigen::Vector3d place;
  for (double& x : place) x = random.uniform(low, high);
  return place;
}

}  // namespace limpet::evaluation
