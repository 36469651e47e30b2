// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace limpet::evaluation {

/// How dense readings are about a place in a plane: the median count of the squares near it that hold any.
/// Area without readings, as what is invented, does not lower it; squares that the border cuts do, a little,
/// which is to the model's favour.
class LocalDensity {
 public:
  /// `edge` of a square, scan's unit, > 0.
  LocalDensity(const std::vector<Eigen::Vector2d>& readings, double edge);

  /// Readings to a unit of area, about a place (three squares each way); 0 where there are none.
  double at(const Eigen::Vector2d& place) const;
  /// The same over all squares.
  double overall() const;

 private:
  using Key = std::uint64_t;
  static Key key(std::int64_t x, std::int64_t y);
  double density(std::vector<int>& counts) const;

  double edge_;
  std::unordered_map<Key, int> count_;
  mutable std::unordered_map<Key, double> known_;  ///< what at() has found, by square
};

}  // namespace limpet::evaluation
