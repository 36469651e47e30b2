// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <limpet/geometry/types.hpp>

namespace limpet::geometry {

/// A uniform grid of square cells over a box of the chart, to sort edges into. Cells are numbered from 0 to
/// count() - 1. Points outside the box belong to the outermost cells.
class CellGrid {
 public:
  CellGrid() = default;
  /// About two cells per edge, but none smaller than 4 grid steps, and no more than 8·edges + 1 rows or
  /// columns over a narrow box. Precondition: `edges` is at least 1.
  CellGrid(const Box2& box, std::size_t edges) : box_(box) {
    const double w = box.high.x - box.low.x, h = box.high.y - box.low.y;
    const double wanted = std::sqrt(w * h / static_cast<double>(2 * edges));
    size_ = std::max({4.0, wanted, std::max(w, h) / static_cast<double>(8 * edges)});
    per_size_ = 1 / size_;
    columns_ = static_cast<int>(w / size_) + 1;
    rows_ = static_cast<int>(h / size_) + 1;
  }

  const Box2& box() const { return box_; }
  double size() const { return size_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  std::size_t count() const { return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_); }
  int column(double x) const { return clamped((x - box_.low.x) * per_size_, columns_); }
  int row(double y) const { return clamped((y - box_.low.y) * per_size_, rows_); }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  /// Calls f(cell number) for all cells that the edge ab touches, and perhaps for some next to them; for ba
  /// it calls it for the same cells.
  template <class F>
  void for_cells_on(Point2 a, Point2 b, F&& f) const {
    const int i0 = column(std::min(a.x, b.x)), i1 = column(std::max(a.x, b.x));
    const int j0 = row(std::min(a.y, b.y)), j1 = row(std::max(a.y, b.y));
    if (i0 == i1 || j0 == j1) {
      for (int j = j0; j <= j1; ++j)
        for (int i = i0; i <= i1; ++i) f(index(i, j));
      return;
    }
    // A slanted edge: in each row the columns that it spans there, and one more on either side to allow for
    // rounding.
    const double slope = (b.x - a.x) / (b.y - a.y);
    const double left = std::min(a.x, b.x), right = std::max(a.x, b.x);
    for (int j = j0; j <= j1; ++j) {
      const double y0 = box_.low.y + j * size_, y1 = y0 + size_;
      const double xa = std::clamp(a.x + (y0 - a.y) * slope, left, right);
      const double xb = std::clamp(a.x + (y1 - a.y) * slope, left, right);
      const int from = std::max(i0, column(std::min(xa, xb)) - 1),
                to = std::min(i1, column(std::max(xa, xb)) + 1);
      for (int i = from; i <= to; ++i) f(index(i, j));
    }
  }

 private:
  static int clamped(double t, int n) { return t <= 0 ? 0 : t >= n - 1 ? n - 1 : static_cast<int>(t); }

  Box2 box_;
  double size_ = 1, per_size_ = 1;
  int columns_ = 0, rows_ = 0;
};

}  // namespace limpet::geometry
