// Copyright the limpet authors. GPL-3.0-or-later.
#include <cmath>

#include "places_internal.hpp"

namespace limpet::following::internal {

Places::Cell Places::cell_of(const Eigen::Vector3d& p) const {
  Cell cell{};
  for (int i = 0; i < 3; ++i)
    cell[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(std::floor(p[i] / size_));
  return cell;
}

bool Places::visit(const Eigen::Vector3d& p) {
  int& visits = visits_[cell_of(p)];
  if (visits >= most_) return false;
  ++visits;
  return true;
}

bool Places::is_worn(const Eigen::Vector3d& p) const {
  const auto found = visits_.find(cell_of(p));
  return found != visits_.end() && found->second >= most_;
}

}  // namespace limpet::following::internal
