// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

namespace limpet::model {

using Box3 = Eigen::AlignedBox3d;

/// Finds the boxes of segments near a place, by their storage slot.
///
/// A hierarchy of hashed grids: a box is kept on the finest level on which it is at most two cells wide, in
/// all cells it touches; a small query looks at one cell a level, or few. Cells are four times as wide from
/// one level to the next. Queries and changes cost less than an R-tree's, whose boxes overlap much here.
class SpatialIndex {
 public:
  /// `smallest` > 0: the width that most boxes do not exceed by much.
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

 private:
  struct Entry {
    Box3 box;
    std::uint32_t slot = 0;
  };
  using Cell = std::vector<Entry>;

  /// A grid that holds only cells in use, in an open-addressed table. Two cells whose keys happen to be the
  /// same share a place there, which costs time and nothing else.
  class Grid {
   public:
    explicit Grid(double width) : width_(width), per_width_(1 / width), places_(16) {}
    double width() const { return width_; }
    void insert(const Entry&);
    void remove(const Entry&);
    void query(const Box3&, std::vector<std::uint32_t>& found) const;
    void query(const Eigen::Vector3d&, std::vector<std::uint32_t>& found) const;
    std::size_t size() const { return size_; }

   private:
    using Index = std::array<std::int64_t, 3>;
    struct Place {
      std::uint64_t key = 0;
      std::uint32_t cell = 0;  ///< one more than the index in cells_; 0: the place is free
    };
    struct Range;

    static std::uint64_t key_of(const Index&);
    std::int64_t index(double x) const {  // rounded down
      const double cells = x * per_width_;
      const auto i = static_cast<std::int64_t>(cells);
      return i - (static_cast<double>(i) > cells);
    }
    Index index_of(const Eigen::Vector3d& p) const { return {index(p.x()), index(p.y()), index(p.z())}; }
    Range range_of(const Box3&) const;
    const Cell* find(const Index&) const;
    Cell& find_or_make(const Index&);
    std::size_t place_of(std::uint64_t key) const;
    void make_room();

    double width_, per_width_;
    std::vector<Place> places_;  ///< a power of two of them, at most half of them taken
    std::vector<Cell> cells_;
    std::size_t size_ = 0;
  };

  std::size_t level_of(const Box3&) const;

  double smallest_;
  std::vector<Grid> levels_;
};

}  // namespace limpet::model
