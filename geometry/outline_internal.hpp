// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <vector>

#include <limpet/geometry/polygon.hpp>

namespace limpet::geometry::internal {

/// A boundary edge of one of the polygons, as put into the arrangement.
struct SourceEdge {
  Point2 a, b;
  Slot slot = kNoSlot;  ///< in its polygon
  Slot next = kNoSlot;  ///< the vertex at its end
};

/// A piece of the union's boundary: it begins at `at` (rounded) and runs along one edge of either polygon, or
/// along one of each where they coincide.
struct OutlinePiece {
  Point2 at;
  Slot vertex = kNoSlot;  ///< the vertex of polygon a that starts here, if it is one (not rounded then)
  Slot edge_a = kNoSlot;  ///< runs along this edge of a
  Slot edge_b = kNoSlot;  ///< runs along this edge of b
};

/// A closed chain of pieces; or an open one, which begins and ends at vertices of a where the boundary goes
/// on outside the window.
struct Outline {
  std::vector<OutlinePiece> pieces;
  Slot end = kNoSlot;  ///< open outlines: the vertex of a after the last piece
};

/// The outlines of a ∪ b within a window around b, interior on the left. `edges_a` are all edges of a that
/// meet the window; `corner_sides` tells where the window's corners lie (+1 inside a, -1 outside, 0 on the
/// boundary). Consecutive pieces of one source edge are joined. Exact in the exact build. False when every
/// corner is on the boundary of a, so that it is not known which faces of the arrangement are inside.
bool union_outlines(const std::vector<SourceEdge>& edges_a, const std::vector<SourceEdge>& edges_b,
                    const Box2& window, const std::vector<int>& corner_sides, std::vector<Outline>& outlines);

/// The four corners of a window, in the order of `corner_sides`.
inline std::vector<Point2> corners(const Box2& w) {
  return {w.low, {w.high.x, w.low.y}, w.high, {w.low.x, w.high.y}};
}

}  // namespace limpet::geometry::internal
