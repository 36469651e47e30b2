// Copyright the limpet authors. GPL-3.0-or-later.
#include "segment_data_internal.hpp"

namespace limpet::model::internal {

SegmentData::Sums& SegmentData::Sums::operator+=(const Sums& other) {
  moments.add(other.moments);
  axis += other.axis;
  variance += other.variance;
  since += other.since;
  return *this;
}

SegmentData::SegmentData(const RawPoint& point, std::int64_t now) : raw_{point}, last_joined_(now) {
  if (point.since < 0) raw_.front().since = now;
  sums_ = {Moments(point.at), point.axis, point.variance, static_cast<double>(raw_.front().since)};
}

void SegmentData::absorb(const SegmentData& other, bool stays_young, std::int64_t now) {
  sums_ += other.sums_;
  if (stays_young)
    raw_.insert(raw_.end(), other.raw_.begin(), other.raw_.end());
  else
    forget_points();
  last_joined_ = now;
}

void SegmentData::keep(const RawPoint& point, std::int64_t now) {
  raw_.push_back(point);
  if (point.since < 0) raw_.back().since = now;
  sums_.since += static_cast<double>(raw_.back().since);
}

void SegmentData::allow_returns() {
  for (RawPoint& point : raw_) point.returned = 0;
}

}  // namespace limpet::model::internal
