// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include <limpet/geometry/types.hpp>

namespace limpet::model::internal {

/// A height map: how a surface lies about its plane (real table tops bend by several times the noise). Sums
/// over the sensor points in each square of a lattice on a polygon's chart; grid steps.
class HeightMap {
 public:
  struct Sum {
    double count = 0, x = 0, y = 0, height = 0;
    void add(const Sum& other) { count += other.count, x += other.x, y += other.y, height += other.height; }
    geometry::Point2 mean() const { return {x / count, y / count}; }
    double mean_height() const { return height / count; }
  };

  void add(double side, const Sum&);
  /// What lies in the square of p, or, where that is little, in the nine around it. Count 0: nothing.
  Sum around(double side, geometry::Point2 p) const;
  bool empty() const { return squares_.empty(); }
  /// All squares, in an order that depends on the surface alone.
  std::vector<Sum> squares() const;
  /// The same with their keys, ascending.
  std::vector<std::pair<std::uint64_t, Sum>> keyed_squares() const;
  static HeightMap of_squares(std::span<const std::pair<std::uint64_t, Sum>> squares) {
    HeightMap map;
    map.squares_.insert(squares.begin(), squares.end());
    return map;
  }

 private:
  std::unordered_map<std::uint64_t, Sum> squares_;
};

}  // namespace limpet::model::internal
