// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace limpet::following::internal {

/// Values at places, found by place. What is found comes in the order in which it was put into its cell, cell
/// by cell in a fixed order: the same calls give the same answers.
template <class T>
class SpaceHash {
 public:
  explicit SpaceHash(double cell) : per_cell_(1 / cell) {}

  void put(const Eigen::Vector3d& at, const T& value) { cells_[key_of(index_of(at))].push_back({at, value}); }
  void clear() { cells_.clear(); }

  /// Removes the values at this place for which gone(value).
  template <class Gone>
  void remove(const Eigen::Vector3d& at, Gone&& gone) {
    const auto cell = cells_.find(key_of(index_of(at)));
    if (cell == cells_.end()) return;
    std::erase_if(cell->second, [&](const Entry& e) { return gone(e.value); });
    if (cell->second.empty()) cells_.erase(cell);
  }

  /// Calls f(place, value) for the values within `reach` of a place, until f returns true. Returns whether it
  /// did.
  template <class F>
  bool any_within(const Eigen::Vector3d& at, double reach, F&& f) const {
    const Eigen::Vector3d around = Eigen::Vector3d::Constant(reach);
    const Index low = index_of(at - around), high = index_of(at + around);
    for (std::int64_t x = low.x; x <= high.x; ++x)
      for (std::int64_t y = low.y; y <= high.y; ++y)
        for (std::int64_t z = low.z; z <= high.z; ++z) {
          const auto cell = cells_.find(key_of({x, y, z}));
          if (cell == cells_.end()) continue;
          for (const Entry& e : cell->second)
            if ((e.at - at).squaredNorm() <= reach * reach && f(e.at, e.value)) return true;
        }
    return false;
  }

  template <class F>
  void for_each_within(const Eigen::Vector3d& at, double reach, F&& f) const {
    any_within(at, reach, [&](const Eigen::Vector3d& place, const T& value) {
      f(place, value);
      return false;
    });
  }

 private:
  struct Index {
    std::int64_t x, y, z;
  };
  struct Entry {
    Eigen::Vector3d at;
    T value;
  };
  Index index_of(const Eigen::Vector3d& p) const {
    const auto index = [&](double x) { return static_cast<std::int64_t>(std::floor(x * per_cell_)); };
    return {index(p.x()), index(p.y()), index(p.z())};
  }
  /// 21 bits of each index: places 2^20 cells away and more share cells, which costs time only.
  static std::uint64_t key_of(const Index& i) {
    constexpr std::uint64_t kMask = (std::uint64_t{1} << 21) - 1;
    return (static_cast<std::uint64_t>(i.x) & kMask) | (static_cast<std::uint64_t>(i.y) & kMask) << 21 |
           (static_cast<std::uint64_t>(i.z) & kMask) << 42;
  }

  double per_cell_;
  std::unordered_map<std::uint64_t, std::vector<Entry>> cells_;
};

}  // namespace limpet::following::internal
