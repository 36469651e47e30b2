// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/geometry/edge_index.hpp>
#include <limpet/geometry/predicates.hpp>

#include "small_vector_internal.hpp"

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
  return active() && grid_.box().contains(box.low) && grid_.box().contains(box.high) &&
         edges <= 4 * built_for_ && edges * 16 >= built_for_;
}

void EdgeIndex::reset(const Box2& box, std::size_t edges) {
  const double width = box.high.x - box.low.x, height = box.high.y - box.low.y;
  // With a margin of a quarter on every side, so that a growing perimeter seldom needs a new grid.
  reset_cells(box.grown(rounded_down(std::max(width, height) / 4) + 4), edges);
}

void EdgeIndex::reset_cells(const Box2& cells_box, std::size_t edges) {
  grid_ = CellGrid(cells_box, edges);
  built_for_ = edges;
  states_.assign(grid_.count(), 0);
  edges_.assign(grid_.count(), {});
}

Point2 EdgeIndex::reference(int i, int j) const {
  return {rounded_down(grid_.box().low.x + (i + 0.5) * grid_.size()) + 0x1p-27,
          rounded_down(grid_.box().low.y + (j + 0.5) * grid_.size()) + 0.5};
}

void EdgeIndex::add(std::uint32_t slot, Point2 a, Point2 b) {
  grid_.for_cells_on(a, b, [&](std::size_t cell) {
    edges_[cell].push_back(slot);
    states_[cell] |= kHasEdges;
  });
}

void EdgeIndex::remove(std::uint32_t slot, Point2 a, Point2 b) {
  grid_.for_cells_on(a, b, [&](std::size_t cell) {
    auto& edges = edges_[cell];
    for (auto& e : edges)
      if (e == slot) {
        e = edges.back();
        edges.pop_back();
        if (edges.empty()) states_[cell] &= static_cast<unsigned char>(~kHasEdges);
        return;
      }
  });
}

int EdgeIndex::references_left_of(Point2 a, Point2 b, int j, int i0, int i1) const {
  const double y = reference(i0, j).y;
  const double x = a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
  const auto left = [&](int i) { return orientation(a, b, reference(i, j)) > 0; };
  int count = std::clamp(grid_.column(x), i0, i1 + 1) - i0;  // an estimate, which the predicate corrects
  while (count > 0 && !left(i0 + count - 1)) --count;
  while (i0 + count <= i1 && left(i0 + count)) ++count;
  return count;
}

void EdgeIndex::flip(std::span<const Segment2> sweep) {
  if (!active() || sweep.empty()) return;
  Box2 box;
  for (const auto& [a, b] : sweep) box.add(a), box.add(b);
  const int i0 = grid_.column(box.low.x), i1 = grid_.column(box.high.x);
  const int j0 = grid_.row(box.low.y), j1 = grid_.row(box.high.y);
  const int width = i1 - i0 + 1;
  // In row j, at position i: the parity of the number of sweep edges that cross the row with exactly i
  // reference points on their left.
  internal::SmallVector<char, 512> crossings(static_cast<std::size_t>(j1 - j0 + 1) * (width + 1));
  for (const auto& [p, q] : sweep) {
    const bool up = p.y < q.y;
    const Point2 a = up ? p : q, b = up ? q : p;
    for (int j = grid_.row(a.y); j <= grid_.row(b.y); ++j) {
      const double y = reference(i0, j).y;
      if ((a.y <= y) == (b.y <= y)) continue;
      crossings[static_cast<std::size_t>(j - j0) * (width + 1) + references_left_of(a, b, j, i0, i1)] ^= 1;
    }
  }
  for (int j = j0; j <= j1; ++j) {
    bool odd = false;  // the parity of the crossings to the right of reference point i
    for (int i = width; i-- > 0;) {
      odd ^= crossings[static_cast<std::size_t>(j - j0) * (width + 1) + i + 1] != 0;
      if (odd) states_[grid_.index(i0 + i, j)] ^= kInside;
    }
  }
}

bool EvenOdd::inside(Point2 p) {
  // An index costs about as much as so many points without one.
  constexpr std::size_t kFewAsked = 64, kFewEdges = 64;
  if (!index_.active()) {
    if (edges_.size() < kFewEdges || asked_++ < kFewAsked) return inside_even_odd(edges_, p);
    Box2 box;
    for (const auto& [a, b] : edges_) box.add(a), box.add(b);
    index_.reset(box, edges_.size());
    for (std::uint32_t i = 0; i < edges_.size(); ++i) index_.add(i, edges_[i].first, edges_[i].second);
    index_.flip(edges_);
  }
  return index_.covers(p) && index_.inside(p, [&](std::uint32_t i) { return edges_[i]; }).value_or(false);
}

}  // namespace limpet::geometry
