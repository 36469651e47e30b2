// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <limpet/model/parameters.hpp>
#include <stdexcept>
#include <vector>

namespace limpet::evaluation {

/// λ of a model, which may grow with the distance to the nearest sensor; scan's unit.
class ResolutionField {
 public:
  /// Throws std::invalid_argument when λ is not positive.
  explicit ResolutionField(const model::Parameters& parameters)
      : fixed_(parameters.resolution),
        per_range_(parameters.resolution_per_range),
        sensors_(parameters.sensors) {
    if (!(fixed_ > 0)) throw std::invalid_argument("the model's resolution must be positive");
  }

  bool grows() const { return per_range_ > 0; }
  double at(const Eigen::Vector3d& place) const { return fixed_ + per_range_ * range(place); }
  /// The largest and the least in a box.
  double largest(const Eigen::Vector3d& low, const Eigen::Vector3d& high) const {
    return at((low + high) / 2) + per_range_ * (high - low).norm() / 2;
  }
  double least(const Eigen::Vector3d& low, const Eigen::Vector3d& high) const {
    return std::max(fixed_, at((low + high) / 2) - per_range_ * (high - low).norm() / 2);
  }

 private:
  double range(const Eigen::Vector3d& place) const {
    if (!(per_range_ > 0)) return 0;
    double range = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& sensor : sensors_) range = std::min(range, (place - sensor).norm());
    return range;
  }

  double fixed_, per_range_;
  std::vector<Eigen::Vector3d> sensors_;
};

}  // namespace limpet::evaluation
