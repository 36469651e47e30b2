// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include <limpet/geometry/types.hpp>

namespace limpet::model::internal {

/// A height map of a surface over its plane (real table tops bend by several times the noise): sums over the
/// sensor points in each square of a lattice on a polygon's chart. Lengths in grid steps; `side` is that of a
/// square.
class HeightMap {
 public:
  struct Sum {
    double count = 0, x = 0, y = 0, height = 0;
    void add(const Sum& other) { count += other.count, x += other.x, y += other.y, height += other.height; }
    geometry::Point2 mean() const { return {x / count, y / count}; }
    double mean_height() const { return height / count; }
  };

  void add(double side, const Sum&);
  /// The sum over the square of p, or, if that has few points, over the 3 × 3 squares around it. Its count
  /// may be 0.
  Sum around(double side, geometry::Point2 p) const;
  bool empty() const { return squares_.empty(); }
  /// All squares, in an order that depends only on their places.
  std::vector<Sum> squares() const;
  /// The same with their keys, which ascend.
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
