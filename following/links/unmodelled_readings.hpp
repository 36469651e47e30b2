// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limpet/model/sensor_point.hpp>
#include <limpet/model/view.hpp>
#include <span>
#include <vector>

namespace limpet::following {

/// The readings of the last sets that no polygon of the model accounts for: obstacles in their own right.
class UnmodelledReadings {
 public:
  /// `within`: what is this near to a polygon is modelled; > 0.
  explicit UnmodelledReadings(double within) : within_(within) {}

  /// A set joins, and those that are modelled by now, or of 80 sets ago, go.
  void look(const model::View&, std::span<const model::SensorPoint> set);
  /// The latest last.
  const std::vector<Eigen::Vector3d>& positions() const { return positions_; }

 private:
  double within_;
  std::int64_t set_ = 0;
  std::vector<Eigen::Vector3d> positions_;
  std::vector<std::int64_t> sets_;  ///< of each position
};

}  // namespace limpet::following
