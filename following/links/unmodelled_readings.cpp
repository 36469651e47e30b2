// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/following/links/unmodelled_readings.hpp>

namespace limpet::following {

void UnmodelledReadings::look(const model::View& view, std::span<const model::SensorPoint> set) {
  constexpr std::int64_t kSets = 80;
  ++set_;
  for (const model::SensorPoint& reading : set) {
    positions_.push_back(reading.position);
    sets_.push_back(set_);
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    if (set_ - sets_[i] >= kSets || view.nearest(positions_[i], within_, {.points = false})) continue;
    positions_[kept] = positions_[i];
    sets_[kept++] = sets_[i];
  }
  positions_.resize(kept);
  sets_.resize(kept);
}

}  // namespace limpet::following
