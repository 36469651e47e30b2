// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

namespace limpet::survey {

/// Balls of any sizes, to ask in which of them a point lies: for each power of two a grid of cells that are
/// as wide as its largest balls or more, so that a ball is in eight of them at most.
class BallIndex {
 public:
  /// Precondition: the radius is positive and finite.
  void add(const Eigen::Vector3d& centre, double radius, std::uint32_t ball) {
    const int level = std::max(std::ilogb(radius) + 2, kLeastLevel);
    Grid& grid = grids_[level];
    grid.per_edge = std::ldexp(1.0, -level);
    const Cell low = cell(grid, centre.array() - radius), high = cell(grid, centre.array() + radius);
    for (std::int64_t x = low[0]; x <= high[0]; ++x)
      for (std::int64_t y = low[1]; y <= high[1]; ++y)
        for (std::int64_t z = low[2]; z <= high[2]; ++z) grid.cells[{x, y, z}].push_back(ball);
  }

  /// Calls f(ball) for all balls in which p lies, and for others near it.
  template <class F>
  void for_each_near(const Eigen::Vector3d& p, F&& f) const {
    for (const auto& [level, grid] : grids_) {
      const auto found = grid.cells.find(cell(grid, p));
      if (found == grid.cells.end()) continue;
      for (const std::uint32_t ball : found->second) f(ball);
    }
  }

 private:
  static constexpr int kLeastLevel = -1000;    ///< so that 2 to its opposite is a number
  static constexpr double kFarthest = 0x1p60;  ///< cells from the origin; what is beyond shares the last ones
  using Cell = std::array<std::int64_t, 3>;
  struct Hash {
    std::size_t operator()(const Cell& c) const {
      const auto part = [&](std::size_t i) { return static_cast<std::uint64_t>(c[i]); };
      std::uint64_t h =
          part(0) * 0x9E3779B97F4A7C15u + part(1) * 0xC2B2AE3D27D4EB4Fu + part(2) * 0x165667B19E3779F9u;
      return static_cast<std::size_t>(h ^ h >> 32);
    }
  };
  struct Grid {
    double per_edge = 1;
    std::unordered_map<Cell, std::vector<std::uint32_t>, Hash> cells;
  };

  static Cell cell(const Grid& grid, const Eigen::Vector3d& p) {
    Cell result;
    for (int i = 0; i < 3; ++i)
      result[static_cast<std::size_t>(i)] =
          static_cast<std::int64_t>(std::clamp(std::floor(p[i] * grid.per_edge), -kFarthest, kFarthest));
    return result;
  }

  std::map<int, Grid> grids_;  ///< by the power of two that is the edge of their cells
};

}  // namespace limpet::survey
