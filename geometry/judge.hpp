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

/// Do two edges meet where they must not? They may meet in a common vertex (equal keys) and nowhere else.
///  (1) Symmetric in the edges, and in the ends of each (swapped together with their keys).
bool in_conflict(const KeyedEdge&, const KeyedEdge&);

/// All pairs of edges in conflict, the lower index first, in ascending order. Found with a uniform grid.
///  (1) They are exactly the pairs, among all, for which in_conflict() is true.
std::vector<std::pair<std::size_t, std::size_t>> find_conflicts(std::span<const KeyedEdge>);

/// Judges edges on their own and against each other: `degenerate_edge`, `crossing` or `valid`.
Verdict judge_edges(std::span<const KeyedEdge>);

/// Judges whole cycles, outer first: each is simple and has at least three vertices, the first is
/// anticlockwise and the others clockwise, all are disjoint, holes lie inside the outer one and outside each
/// other. For n edges of similar lengths it takes O(n), and O(n) more for each hole.
///  (1) Where cycles start and the order of the holes do not matter;
///  (2) motions keep the verdict, and so does the reflection together with reversing all cycles.
Verdict judge_cycles(std::span<const std::vector<NewVertex>> cycles);

/// Judges the whole polygon from scratch. Polygon::judge() ensures the same by induction over edits.
Verdict judge_polygon(const Polygon&);

}  // namespace limpet::geometry
