// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <deque>
#include <limpet/model/sensor_point.hpp>
#include <span>

namespace limpet::following {

/// Readings that a robot is kept off although the model may not have them yet, or smooths them away: those of
/// the last sets.
class RecentReadings {
 public:
  /// A set of readings joins, and the set 80 sets ago goes.
  void add(std::span<const model::SensorPoint> set) {
    for (const model::SensorPoint& reading : set) positions_.push_back(reading.position);
    sizes_.push_back(set.size());
    if (sizes_.size() <= kSets) return;
    positions_.erase(positions_.begin(), positions_.begin() + static_cast<std::ptrdiff_t>(sizes_.front()));
    sizes_.pop_front();
  }
  /// The latest last.
  const std::deque<Eigen::Vector3d>& positions() const { return positions_; }

 private:
  static constexpr std::size_t kSets = 80;

  std::deque<Eigen::Vector3d> positions_;
  std::deque<std::size_t> sizes_;  ///< of the sets
};

}  // namespace limpet::following
