// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <utility>
#include <vector>

#include <limpet/survey/random.hpp>

namespace limpet::following {

inline constexpr double kLambda = 0.05;
inline const Eigen::Vector3d kUp(0, 0, 1);
inline constexpr double kStep = kLambda;  ///< of a travel

inline Eigen::Vector3d random_vector(survey::Random& random) {
  return {random.normal(), random.normal(), random.normal()};
}
inline Eigen::Vector3d random_place(survey::Random& random, double size) {
  const double x = random.uniform(-size, size), y = random.uniform(-size, size);
  return {x, y, random.uniform(-size, size)};
}
inline Eigen::Vector3d random_direction(survey::Random& random) {
  for (;;) {
    const Eigen::Vector3d p = random_place(random, 1);
    if (p.squaredNorm() > 0.01 && p.squaredNorm() < 1) return p.normalized();
  }
}
/// A turn and a shift by up to `size` along each axis.
inline Eigen::Isometry3d random_rigid_motion(survey::Random& random, double size) {
  const double w = random.normal(), x = random.normal(), y = random.normal(), z = random.normal();
  Eigen::Isometry3d motion(Eigen::Quaterniond(w, x, y, z).normalized());
  motion.pretranslate(random_place(random, size));
  return motion;
}
template <class T>
void shuffle(survey::Random& random, std::vector<T>& values) {
  for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[random.below(i)]);
}

}  // namespace limpet::following
