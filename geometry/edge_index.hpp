// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <limpet/geometry/cell_grid.hpp>

namespace limpet::geometry {

/// A directed boundary edge, by its ends.
using Segment2 = std::pair<Point2, Point2>;

/// Is p inside the closed chains made of these edges, by the even-odd rule? p must not lie on one of them.
///  (1) Order and direction of the edges do not matter;
///  (2) of two sets of chains together it is the exclusive or;
///  (3) so edges that are there twice are not there;
///  (4) motions (predicates.hpp) and the mirror keep it.
bool inside_even_odd(std::span<const Segment2> edges, Point2 p);

/// Finds the edges near a place, and on which side of the boundary it lies, without looking at the rest of
/// the boundary.
///
/// A uniform grid of cells over the polygon's box lists the edges that touch each cell. Each cell has a
/// reference point, and knows whether that is inside: a point's side then follows from the edges of its own
/// cell. An edit flips the reference points it sweeps over. Small polygons (fewer than kMinimum edges) are
/// not indexed: there the index names all slots.
///
/// Reference points have a half and a 2^-27 as fractions: no edge between grid points below 2^26 steps passes
/// through one, because dx/2 - dy/2^27 is whole only for dx = dy = 0. Where an edge does pass through one, it
/// counts as a little further in +x.
class EdgeIndex {
 public:
  static constexpr std::size_t kMinimum = 24;

  bool active() const { return !states_.empty(); }
  /// Can it hold edges in this box, at this number of edges, without being built anew?
  bool fits(const Box2& box, std::size_t edges) const;

  /// Starts anew for a boundary of `edges` edges in `box`; all edges are then added by add().
  void reset(const Box2& box, std::size_t edges);
  /// The same with the very cells of an index that was built for `edges` and had cells_box() as its box.
  void reset_cells(const Box2& cells_box, std::size_t edges);
  const Box2& cells_box() const { return grid_.box(); }
  std::size_t built_for() const { return built_for_; }
  void clear() { states_.clear(), edges_.clear(); }
  void add(std::uint32_t slot, Point2 a, Point2 b);
  void remove(std::uint32_t slot, Point2 a, Point2 b);

  /// Flips the side of every reference point inside the swept region (even-odd).
  void flip(std::span<const Segment2> sweep);

  /// The edges of p's cell, its reference point and whether that is inside. Precondition: active, p in the
  /// box.
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
  Point2 reference_at(Point2 p) const { return reference(grid_.column(p.x), grid_.row(p.y)); }
  bool covers(Point2 p) const { return grid_.box().contains(p); }

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
  /// How many of the references i0..i1 of row j lie left of the upward edge ab, which crosses the row.
  int references_left_of(Point2 a, Point2 b, int j, int i0, int i1) const;

  CellGrid grid_;
  std::size_t built_for_ = 0;
  // Most cells have no edges: what is asked of them is kept apart, and small.
  static constexpr unsigned char kInside = 1, kHasEdges = 2;
  std::vector<unsigned char> states_;  ///< by cell; kInside is about its reference point
  std::vector<std::vector<std::uint32_t>> edges_;
};

}  // namespace limpet::geometry
