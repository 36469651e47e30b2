// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <limpet/geometry/cell_grid.hpp>
#include <limpet/geometry/predicates.hpp>

namespace limpet::geometry {

/// A directed boundary edge, by its ends.
using Segment2 = std::pair<Point2, Point2>;

/// Is p inside the closed chains made of these edges, by the even-odd rule? Precondition: p lies on none of
/// them.
///  (1) The order and the direction of the edges do not matter;
///  (2) the answer for two sets of chains taken together is the exclusive or of the answers for each;
///  (3) so two copies of the same edge cancel each other;
///  (4) it is invariant under motions and reflection (predicates.hpp).
bool inside_even_odd(std::span<const Segment2> edges, Point2 p);

/// A spatial index of a polygon's edges: finds the edges near a point, and tells whether the point is inside,
/// without visiting the rest of the boundary.
///
/// It is a uniform grid over the polygon's bounding box. Each cell lists the edges that touch it, has a
/// reference point, and stores whether that point is inside the polygon; for any other point of the cell,
/// that follows from the cell's own edges that separate the two. An edit flips what is stored of the
/// reference points in the region it sweeps over. A polygon of fewer than kMinimum edges has no grid
/// (active() is false): searches then visit all slots.
///
/// Reference points have the fractional parts 2^-27 in x and 1/2 in y. An edge between grid points below 2^26
/// steps cannot pass through one: with (dx, dy) its direction, dx/2 - dy/2^27 would have to be whole, which
/// it is only for dx = dy = 0. Where coordinates are larger and an edge does pass through one, the reference
/// point is taken to lie infinitesimally further in +x.
class EdgeIndex {
 public:
  static constexpr std::size_t kMinimum = 24;

  bool active() const { return !states_.empty(); }
  /// Does the grid suit a boundary of so many edges in this box? If not, it should be rebuilt.
  bool fits(const Box2& box, std::size_t edges) const;

  /// An empty grid for a boundary of `edges` edges in `box`. The caller then adds all edges with add() and
  /// flips the region inside them.
  void reset(const Box2& box, std::size_t edges);
  /// The same, with exactly the cells of an earlier index whose cells_box() and built_for() these are.
  void reset_cells(const Box2& cells_box, std::size_t edges);
  const Box2& cells_box() const { return grid_.box(); }
  std::size_t built_for() const { return built_for_; }
  void clear() { states_.clear(), edges_.clear(); }
  void add(std::uint32_t slot, Point2 a, Point2 b);
  void remove(std::uint32_t slot, Point2 a, Point2 b);

  /// Flips the stored side of every reference point inside the region that these edges bound by the even-odd
  /// rule.
  void flip(std::span<const Segment2> sweep);

  /// The edges of p's cell, and whether its reference point is inside. Precondition: active, p in the box.
  struct Cell {
    std::span<const std::uint32_t> edges;
    bool inside = false;
  };
  Cell cell_at(Point2 p) const {
    const std::size_t i = grid_.index(grid_.column(p.x), grid_.row(p.y));
    const bool inside = (states_[i] & kInside) != 0;
    if ((states_[i] & kHasEdges) == 0) return {{}, inside};
    return {edges_[i], inside};
  }
  /// Is p inside the boundary, of which ends(slot) is an edge? Nothing when p is on it. Precondition as of
  /// cell_at().
  template <class Ends>
  std::optional<bool> inside(Point2 p, Ends&& ends) const {
    // Along the line from p to the reference point of its cell, each edge that is crossed changes the side.
    // The reference point is taken to lie infinitesimally further in +x, as in flip(), since beyond 2^26
    // steps it may lie on an edge.
    const Cell cell = cell_at(p);
    if (cell.edges.empty()) return cell.inside;
    const Point2 r = reference_at(p);
    const Box2 way = box_of(p, r);
    const auto left_of_way = [&](Point2 v) {
      const int side = orientation(p, r, v);
      return side != 0 ? side > 0 : v.y > p.y;
    };
    bool inside = cell.inside;
    for (const std::uint32_t i : cell.edges) {
      const auto [a, b] = ends(i);
      if (!way.meets(box_of(a, b))) continue;
      const int side_p = orientation(a, b, p);
      if (side_p == 0) {
        if (box_of(a, b).contains(p)) return std::nullopt;
        continue;  // p is on the edge's line beyond its ends, so the way does not cross it
      }
      int side_r = orientation(a, b, r);
      if (side_r == 0) side_r = a.y < b.y ? -1 : 1;
      inside ^= side_p != side_r && left_of_way(a) != left_of_way(b);
    }
    return inside;
  }
  Point2 reference_at(Point2 p) const { return reference(grid_.column(p.x), grid_.row(p.y)); }
  bool covers(Point2 p) const { return grid_.box().contains(p); }

  /// Calls f(slot) for the edges in the cells that `box` meets (without a grid for the numbers below
  /// `slots`), perhaps more than once for an edge, until f returns true. Returns whether it did.
  template <class F>
  bool any_near(const Box2& box, std::size_t slots, F&& f) const {
    if (!active()) {
      for (std::uint32_t i = 0; i < slots; ++i)
        if (f(i)) return true;
      return false;
    }
    if (!box.meets(grid_.box())) return false;
    const int i0 = grid_.column(box.low.x), i1 = grid_.column(box.high.x);
    const int j0 = grid_.row(box.low.y), j1 = grid_.row(box.high.y);
    for (int j = j0; j <= j1; ++j)
      for (int i = i0; i <= i1; ++i) {
        const std::size_t cell = grid_.index(i, j);
        if ((states_[cell] & kHasEdges) == 0) continue;
        for (const std::uint32_t slot : edges_[cell])
          if (f(slot)) return true;
      }
    return false;
  }

 private:
  Point2 reference(int i, int j) const;
  /// How many of the reference points i0..i1 of row j lie on the left of ab. Precondition: ab leads upwards
  /// and crosses the line through the row's reference points.
  int references_left_of(Point2 a, Point2 b, int j, int i0, int i1) const;

  CellGrid grid_;
  std::size_t built_for_ = 0;
  // Most cells have no edges, so what is asked of every cell is kept apart from the lists, in a byte each.
  static constexpr unsigned char kInside = 1, kHasEdges = 2;
  std::vector<unsigned char> states_;  ///< by cell; kInside: its reference point is inside
  std::vector<std::vector<std::uint32_t>> edges_;
};

/// inside_even_odd() of the same edges for many points: once some have been asked for, by an index. The edges
/// have to stay where they are.
class EvenOdd {
 public:
  explicit EvenOdd(std::span<const Segment2> edges) : edges_(edges) {}
  bool inside(Point2 p);

 private:
  std::span<const Segment2> edges_;
  std::size_t asked_ = 0;
  EdgeIndex index_;
};

}  // namespace limpet::geometry
