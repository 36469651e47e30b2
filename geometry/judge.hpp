// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <limpet/geometry/polygon.hpp>

namespace limpet::geometry {

/// An edge of a candidate with keys for its end vertices: edges that share a vertex share its key.
struct KeyedEdge {
  Point2 a, b;
  std::uint64_t key_a = 0, key_b = 0;
};

/// Do two edges break simplicity? They may meet in a common vertex (equal keys) and nowhere else.
///  (1) Symmetric in the edges and, keys going along, in their ends.
bool in_conflict(const KeyedEdge&, const KeyedEdge&);

/// All pairs of edges in conflict, the lower index first, in ascending order.
///  (1) They are those in_conflict() names among all pairs: the cells they are looked for in do not show.
std::vector<std::pair<std::size_t, std::size_t>> find_conflicts(std::span<const KeyedEdge>);

/// Judges edges against each other: lengths and conflicts, those near each other by a grid of cells.
Verdict judge_edges(std::span<const KeyedEdge>);

/// Judges whole cycles, outer first: each simple with three vertices or more, the first anticlockwise and the
/// others clockwise, all disjoint, holes inside the outer one and outside each other. O(n) for boundaries
/// whose edges are of about one length.
///  (1) No start of a cycle and no order of the holes is special;
///  (2) motions keep the verdict, and so does the mirror with all cycles reversed.
Verdict judge_cycles(std::span<const std::vector<NewVertex>> cycles);

/// The whole polygon judged from scratch: what judge(Edit) keeps by induction.
Verdict judge_polygon(const Polygon&);

}  // namespace limpet::geometry
