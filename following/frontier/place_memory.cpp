// Copyright the limpet authors. GPL-3.0-or-later.
#include "place_memory_internal.hpp"

namespace limpet::following::internal {

using Eigen::Vector3d;

std::size_t PlaceMemory::find(const Vector3d& at, const Vector3d& normal) const {
  constexpr double kSameWay = 0.85;
  double best = near_ * near_;
  std::size_t found = tries_.size();
  places_.for_each_within(at, near_, [&](const Vector3d& place, const Place& p) {
    const double d2 = (place - at).squaredNorm();
    if (p.normal.dot(normal) < kSameWay || d2 > best) return;
    best = d2, found = p.index;
  });
  return found;
}

PlaceMemory::Tries PlaceMemory::at(const Vector3d& at, const Vector3d& normal) const {
  const std::size_t i = find(at, normal);
  return i < tries_.size() ? tries_[i] : Tries{};
}

PlaceMemory::Tries& PlaceMemory::tries(const Vector3d& at, const Vector3d& normal) {
  const std::size_t i = find(at, normal);
  if (i < tries_.size()) return tries_[i];
  places_.put(at, {normal, tries_.size()});
  return tries_.emplace_back();
}

}  // namespace limpet::following::internal
