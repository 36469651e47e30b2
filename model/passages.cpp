// Copyright the limpet authors. GPL-3.0-or-later.
#include "passages_internal.hpp"

#include <algorithm>

#include "thresholds_internal.hpp"

namespace limpet::model::internal {

std::int64_t* Passages::count_at(const Eigen::Vector3d& p, double apart) {
  const auto near = std::find_if(places_.begin(), places_.end(), [&](const Place& place) {
    return (place.at - p).squaredNorm() < apart * apart;
  });
  if (near != places_.end()) return &near->count;
  if (places_.size() == kMostPassages) return nullptr;
  places_.push_back({p, 0});
  return &places_.back().count;
}

void Passages::add(const Eigen::Vector3d& p, double apart) {
  if (std::int64_t* count = count_at(p, apart)) ++*count;
}

void Passages::add(const Passages& other, double apart) {
  for (const Place& place : other.places_)
    if (std::int64_t* count = count_at(place.at, apart)) *count = std::max(*count, place.count);
  rays_ += other.rays_, through_ += other.through_;
}

Passages Passages::split(const std::function<bool(const Eigen::Vector3d&)>& there, double share) {
  Passages part;
  std::erase_if(places_, [&](const Place& place) {
    const bool goes = there(place.at);
    if (goes) part.places_.push_back(place);
    return goes;
  });
  const auto portion = [&](std::int64_t& of) {
    const auto goes = static_cast<std::int64_t>(share * static_cast<double>(of));
    of -= goes;
    return goes;
  };
  part.rays_ = portion(rays_), part.through_ = portion(through_);
  return part;
}

}  // namespace limpet::model::internal
