// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace limpet::model {

using Box3 = Eigen::AlignedBox3d;

/// A spatial index of boxes, each named by a slot.
///
/// A hierarchy of hashed grids, whose cells are four times as wide from one level to the next. A box is kept
/// in all the cells it touches on the finest level on which it is at most two cells wide. A small query looks
/// at one cell per level, or a few. Queries and changes are cheaper than in an R-tree, whose boxes would
/// overlap much here.
class SpatialIndex {
 public:
  /// `smallest` > 0: width of the finest cells; most boxes should be at most about as wide.
  explicit SpatialIndex(double smallest = 1) : smallest_(smallest) {}

  /// Precondition: finite, within 2⁶² smallest widths of the origin.
  void insert(const Box3&, std::uint32_t slot);
  /// Precondition: inserted with exactly this box.
  void remove(const Box3&, std::uint32_t slot);
  /// Slots whose boxes meet `box`, in no particular order; `found` is cleared first.
  void query(const Box3& box, std::vector<std::uint32_t>& found) const;
  /// Slots whose boxes hold `point`.
  void query(const Eigen::Vector3d& point, std::vector<std::uint32_t>& found) const;
  std::size_t size() const;
  /// A box around all boxes, including removed ones; empty when none has been inserted.
  Box3 bounds() const;

  /// Calls f(slot) for the boxes that meet `box`, each once, in no particular order, until f returns true.
  /// Returns whether it did. `box` may be infinite. Allocates nothing.
  template <class F>
  bool any_of(const Box3& box, F&& f) const {
    return std::any_of(levels_.begin(), levels_.end(),
                       [&](const Grid& grid) { return grid.size() > 0 && grid.any_of(box, f); });
  }

  struct Ray {
    Eigen::Vector3d from, axis;
    Eigen::Vector3d at(double t) const { return from + t * axis; }
    /// The interval of t in which the ray is inside the box; first > second: it is nowhere inside.
    std::pair<double, double> within(const Box3&) const;
    /// Where the ray enters the box, 0 if it starts inside; nothing when it passes by.
    std::optional<double> entry(const Box3& box) const {
      const auto [enters, leaves] = within(box);
      const double first = std::max(0.0, enters);
      return first <= leaves ? std::optional(first) : std::nullopt;
    }
  };

  /// Walks along the ray from + t·axis, 0 ≤ t ≤ range, level by level, in pieces about one cell long: calls
  /// f(slot, begin, end) for the boxes within `slack` of the piece from t = begin to end, and perhaps for
  /// others near it. The pieces of a level cover all t. f returns the range that is still of interest, at
  /// most the previous one. On a level where there would be more pieces than cells, the ray is one piece.
  /// Allocates nothing. Precondition: `axis` is a unit vector; `slack` covers the rounding of coordinates
  /// along the ray.
  template <class F>
  void walk(const Ray& ray, double range, double slack, F&& f) const {
    for (const Grid& grid : levels_)
      if (grid.size() > 0) range = grid.walk(ray, range, slack, f);
  }

 private:
  struct Entry {
    Box3 box;
    std::uint32_t slot = 0;
  };
  using Cell = std::vector<Entry>;

  using Index = std::array<std::int64_t, 3>;

  static bool same(const Index& a, const Index& b) {  // a[0] differs most often
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
  }

  /// The cells that a box touches.
  struct Range {
    Index low, high;

    double count() const {
      double n = 1;
      for (std::size_t i = 0; i < 3; ++i) n *= static_cast<double>(high[i] - low[i] + 1);
      return n;
    }
    template <class F>
    bool any_of(F&& f) const {
      Index at{};
      for (at[0] = low[0]; at[0] <= high[0]; ++at[0])
        for (at[1] = low[1]; at[1] <= high[1]; ++at[1])
          for (at[2] = low[2]; at[2] <= high[2]; ++at[2])
            if (f(at)) return true;
      return false;
    }
    template <class F>
    void for_each(F&& f) const {
      any_of([&](const Index& at) {
        f(at);
        return false;
      });
    }
  };

  static std::uint64_t key_of(const Index& at) {
    std::uint64_t key = 0;
    for (const std::int64_t i : at) {
      key = (key ^ static_cast<std::uint64_t>(i)) * 0x9e3779b97f4a7c15u;
      key ^= key >> 29;
    }
    return key;
  }

  /// The set of cells of a grid that are in use, as bits of blocks of 4 × 4 × 4 cells, so that a query skips
  /// large empty regions.
  class Blocks {
   public:
    Blocks() : places_(16) {}
    void add(const Index& cell);
    void remove(const Index& cell);
    /// Calls f(cell) for the cells in use in the range until f returns true. Returns whether it did.
    template <class F>
    bool any_of(const Range& range, F&& f) const;

   private:
    struct Block {
      Index at{};
      std::uint64_t cells = 0;  ///< one bit for each cell, set if it is in use
      bool taken = false;       ///< is this place in the table taken?
    };
    static Index block_of(const Index& cell) { return {cell[0] >> 2, cell[1] >> 2, cell[2] >> 2}; }
    static std::uint64_t bit_of(const Index& cell) {
      return std::uint64_t{1} << ((cell[0] & 3) + 4 * (cell[1] & 3) + 16 * (cell[2] & 3));
    }
    std::size_t place_of(const Index& block) const {
      const std::size_t mask = places_.size() - 1;
      std::size_t i = key_of(block) & mask;
      while (places_[i].taken && !same(places_[i].at, block)) i = (i + 1) & mask;
      return i;
    }
    void make_room();
    template <class F>
    static bool any_of(const Block&, const Range&, F&& f);

    std::vector<Block> places_;  ///< a power of two, at most half of them taken
    std::size_t taken_ = 0;
  };

  /// A grid that stores its cells in a hash table with open addressing. Cells with the same key share an
  /// entry, which costs time only.
  class Grid {
   public:
    explicit Grid(double width) : width_(width), per_width_(1 / width), places_(16) {}
    double width() const { return width_; }
    void insert(const Entry&);
    void remove(const Entry&);
    void query(const Eigen::Vector3d&, std::vector<std::uint32_t>& found) const;
    std::size_t size() const { return size_; }
    const Box3& bounds() const { return bounds_; }

    template <class F>
    bool any_of(const Box3& asked, F&& f) const;
    template <class F>
    double walk(const Ray& ray, double range, double slack, F&& f) const;

   private:
    struct Place {
      std::uint64_t key = 0;
      std::uint32_t cell = 0;  ///< one more than the index in cells_; 0: the place is free
    };
    std::int64_t index(double x) const {  // rounded down
      const double cells = x * per_width_;
      const auto i = static_cast<std::int64_t>(cells);
      return i - (static_cast<double>(i) > cells);
    }
    Index index_of(const Eigen::Vector3d& p) const { return {index(p.x()), index(p.y()), index(p.z())}; }
    Range range_of(const Box3& box) const { return {index_of(box.min()), index_of(box.max())}; }
    const Cell* find(const Index& at) const {
      const Place& place = places_[place_of(key_of(at))];
      return place.cell == 0 ? nullptr : &cells_[place.cell - 1];
    }
    Cell& find_or_make(const Index&);
    /// The place of a key in the table, or the free place where it would be put.
    std::size_t place_of(std::uint64_t key) const {
      const std::size_t mask = places_.size() - 1;
      std::size_t i = key & mask;
      while (places_[i].cell != 0 && places_[i].key != key) i = (i + 1) & mask;
      return i;
    }
    void make_room();

    double width_, per_width_;
    std::vector<Place> places_;  ///< a power of two, at most half of them taken
    std::vector<Cell> cells_;
    Blocks in_use_;
    std::size_t size_ = 0;
    Box3 bounds_;  ///< of all boxes ever inserted
  };

  std::size_t level_of(const Box3&) const;

  double smallest_;
  std::vector<Grid> levels_;
};

template <class F>
bool SpatialIndex::Grid::any_of(const Box3& asked, F&& f) const {
  const Box3 box = asked.intersection(bounds_);
  if (box.isEmpty()) return false;
  // An entry may be in several cells; it is reported only in the cell of the lowest corner of its part within
  // the box.
  const auto look = [&](const Index& at) {
    const Cell* cell = find(at);
    return cell && std::any_of(cell->begin(), cell->end(), [&](const Entry& e) {
             return e.box.intersects(box) && same(index_of(e.box.min().cwiseMax(box.min())), at) && f(e.slot);
           });
  };
  // Of so few cells it costs no more to try them all.
  constexpr double kFew = 8;
  const Range range = range_of(box);
  return range.count() <= kFew ? range.any_of(look) : in_use_.any_of(range, look);
}

template <class F>
bool SpatialIndex::Blocks::any_of(const Range& range, F&& f) const {
  const Range blocks{block_of(range.low), block_of(range.high)};
  if (blocks.count() <= static_cast<double>(taken_))
    return blocks.any_of([&](const Index& at) {
      const Block& block = places_[place_of(at)];
      return block.cells != 0 && any_of(block, range, f);
    });
  return std::any_of(places_.begin(), places_.end(),
                     [&](const Block& block) { return block.cells != 0 && any_of(block, range, f); });
}

template <class F>
bool SpatialIndex::Blocks::any_of(const Block& block, const Range& range, F&& f) {
  std::uint64_t wanted = block.cells;
  constexpr std::array<std::uint64_t, 3> kAll{0xf, 0x1111, 0x1000100010001}, kStride{1, 4, 16};
  std::uint64_t in_range = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int64_t first = 4 * block.at[i];
    const std::int64_t from = std::max(range.low[i] - first, std::int64_t{0}),
                       to = std::min(range.high[i] - first, std::int64_t{3});
    if (from > to) return false;
    // A bit for each layer from–to along this axis; the product over the axes has a bit for each cell.
    const std::uint64_t layers = (kAll[i] << (kStride[i] * static_cast<std::uint64_t>(from))) &
                                 (kAll[i] >> (kStride[i] * static_cast<std::uint64_t>(3 - to)));
    in_range *= layers;
  }
  for (wanted &= in_range; wanted != 0; wanted &= wanted - 1) {
    const std::int64_t bit = std::countr_zero(wanted);
    if (f(Index{4 * block.at[0] + (bit & 3), 4 * block.at[1] + ((bit >> 2) & 3),
                4 * block.at[2] + (bit >> 4)}))
      return true;
  }
  return false;
}

template <class F>
double SpatialIndex::Grid::walk(const Ray& ray, double range, double slack, F&& f) const {
  constexpr double kAll = std::numeric_limits<double>::infinity();
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(slack);
  const auto [enters, leaves] = ray.within(Box3(bounds_.min() - margin, bounds_.max() + margin));
  const double start = std::max(0.0, enters), stop = std::min(range, leaves);
  if (!(start <= stop)) return range;
  const auto look = [&](double from, double to, double begin, double end) {
    const Eigen::Vector3d a = ray.at(from), b = ray.at(to);
    any_of(Box3(a.cwiseMin(b) - margin, a.cwiseMax(b) + margin), [&](std::uint32_t slot) {
      range = f(slot, begin, end);
      return false;
    });
  };
  const double pieces = (stop - start) * per_width_;
  if (!(pieces < static_cast<double>(cells_.size()))) {
    look(start, stop, -kAll, kAll);
    return range;
  }
  double end = -kAll;
  for (double i = 0; i <= pieces && end <= range; ++i) {
    const double begin = end, from = start + i * width_, to = start + (i + 1) * width_;
    end = i + 1 <= pieces ? to : kAll;
    look(from, std::min(to, stop), begin, end);
  }
  return range;
}

}  // namespace limpet::model
