// Copyright the limpet authors. GPL-3.0-or-later.
#include "passages_internal.hpp"

#include <algorithm>

#include "thresholds_internal.hpp"

namespace limpet::model::internal {

void Passages::add(const Eigen::Vector3d& p, double apart, std::int64_t count) {
  const auto near = std::find_if(places_.begin(), places_.end(), [&](const Place& place) {
    return (place.at - p).squaredNorm() < apart * apart;
  });
  if (near != places_.end())
    near->count += count;
  else if (places_.size() < kMostPassages)
    places_.push_back({p, count});
}

void Passages::add(const Passages& other, double apart) {
  for (const Place& place : other.places_) add(place.at, apart, place.count);
  rays_ += other.rays_, through_ += other.through_;
}

}  // namespace limpet::model::internal
