// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/geometry/edge_index.hpp>
#include <limpet/geometry/predicates.hpp>

namespace limpet::geometry {

bool inside_even_odd(std::span<const Segment2> edges, Point2 p) {
  bool inside = false;
  for (const auto& [a, b] : edges) {
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    if (std::max(a.x, b.x) < p.x) continue;
    // The ray from p in direction +x crosses ab when p is left of the upward directed edge.
    const bool left = a.y < b.y ? orientation(a, b, p) > 0 : orientation(b, a, p) > 0;
    inside ^= left;
  }
  return inside;
}

bool EdgeIndex::fits(const Box2& box, std::size_t edges) const {
  if (edges < kMinimum) return !active();
  return active() && box_.contains(box.low) && box_.contains(box.high) && edges <= 4 * built_for_ &&
         edges * 16 >= built_for_;
}

void EdgeIndex::reset(const Box2& box, std::size_t edges) {
  const double width = box.high.x - box.low.x, height = box.high.y - box.low.y;
  // A quarter of room on every side, so that a growing perimeter seldom asks for a new grid.
  box_ = box.grown(std::floor(std::max(width, height) / 4) + 4);
  const double w = box_.high.x - box_.low.x, h = box_.high.y - box_.low.y;
  const double wanted = std::sqrt(w * h / static_cast<double>(2 * edges));
  size_ = std::max({4.0, wanted, std::max(w, h) / static_cast<double>(8 * edges)});
  columns_ = static_cast<int>(w / size_) + 1;
  rows_ = static_cast<int>(h / size_) + 1;
  built_for_ = edges;
  cells_.assign(static_cast<std::size_t>(columns_) * rows_, Cell{});
}

Point2 EdgeIndex::reference(int i, int j) const {
  return {rounded_down(box_.low.x + (i + 0.5) * size_) + 0x1p-27,
          rounded_down(box_.low.y + (j + 0.5) * size_) + 0.5};
}

template <class F>
void EdgeIndex::for_cells_on(Point2 a, Point2 b, F&& f) {
  const int i0 = column(std::min(a.x, b.x)), i1 = column(std::max(a.x, b.x));
  const int j0 = row(std::min(a.y, b.y)), j1 = row(std::max(a.y, b.y));
  if (i0 == i1 || j0 == j1) {
    for (int j = j0; j <= j1; ++j)
      for (int i = i0; i <= i1; ++i) f(cells_[index(i, j)]);
    return;
  }
  // A slanted edge: in every row, the columns between its ends there, and one more on either side for
  // rounding.
  const double slope = (b.x - a.x) / (b.y - a.y);
  const double left = std::min(a.x, b.x), right = std::max(a.x, b.x);
  for (int j = j0; j <= j1; ++j) {
    const double y0 = box_.low.y + j * size_, y1 = y0 + size_;
    const double xa = std::clamp(a.x + (y0 - a.y) * slope, left, right);
    const double xb = std::clamp(a.x + (y1 - a.y) * slope, left, right);
    const int from = std::max(i0, column(std::min(xa, xb)) - 1),
              to = std::min(i1, column(std::max(xa, xb)) + 1);
    for (int i = from; i <= to; ++i) f(cells_[index(i, j)]);
  }
}

void EdgeIndex::add(std::uint32_t slot, Point2 a, Point2 b) {
  for_cells_on(a, b, [slot](Cell& cell) { cell.edges.push_back(slot); });
}

void EdgeIndex::remove(std::uint32_t slot, Point2 a, Point2 b) {
  for_cells_on(a, b, [slot](Cell& cell) {
    auto& edges = cell.edges;
    for (auto& e : edges)
      if (e == slot) {
        e = edges.back();
        edges.pop_back();
        return;
      }
  });
}

int EdgeIndex::references_left_of(Point2 a, Point2 b, int j, int i0, int i1) const {
  const double y = reference(i0, j).y;
  const double x = a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
  const auto left = [&](int i) { return orientation(a, b, reference(i, j)) > 0; };
  int count = std::clamp(column(x), i0, i1 + 1) - i0;  // a guess, then made exact
  while (count > 0 && !left(i0 + count - 1)) --count;
  while (i0 + count <= i1 && left(i0 + count)) ++count;
  return count;
}

void EdgeIndex::flip(std::span<const Segment2> sweep) {
  if (!active() || sweep.empty()) return;
  Box2 box;
  for (const auto& [a, b] : sweep) box.add(a), box.add(b);
  const int i0 = column(box.low.x), i1 = column(box.high.x), j0 = row(box.low.y), j1 = row(box.high.y);
  const int width = i1 - i0 + 1;
  // crossings(i, j): is the number of sweep edges that cross the row with exactly i references on their left
  // odd?
  static thread_local std::vector<char> crossings;
  crossings.assign(static_cast<std::size_t>(j1 - j0 + 1) * (width + 1), 0);
  for (const auto& [p, q] : sweep) {
    const bool up = p.y < q.y;
    const Point2 a = up ? p : q, b = up ? q : p;
    for (int j = row(a.y); j <= row(b.y); ++j) {
      const double y = reference(i0, j).y;
      if ((a.y <= y) == (b.y <= y)) continue;
      crossings[static_cast<std::size_t>(j - j0) * (width + 1) + references_left_of(a, b, j, i0, i1)] ^= 1;
    }
  }
  for (int j = j0; j <= j1; ++j) {
    bool odd = false;  // crossings to the right of reference i
    for (int i = width; i-- > 0;) {
      odd ^= crossings[static_cast<std::size_t>(j - j0) * (width + 1) + i + 1] != 0;
      cells_[index(i0 + i, j)].inside ^= odd;
    }
  }
}

}  // namespace limpet::geometry
