// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <map>

namespace limpet::following::internal {

/// Counts how often a goal was chosen near a place. Edges and segments get new identities whenever the model
/// changes them, so that only by place can it be seen that a goal has been pursued before; the surface has a
/// finite number of places, so that a run that gives each up after a number of visits ends.
class Places {
 public:
  /// `size`: edge of the cubic cells in which places are one, scan's unit, > 0.
  Places(double size, int most) : size_(size), most_(most) {}

  /// Counts a visit. False when there have been too many: the place is worn out.
  bool visit(const Eigen::Vector3d&);
  bool is_worn(const Eigen::Vector3d&) const;

 private:
  using Cell = std::array<std::int64_t, 3>;
  Cell cell_of(const Eigen::Vector3d&) const;

  double size_;
  int most_;
  std::map<Cell, int> visits_;
};

}  // namespace limpet::following::internal
