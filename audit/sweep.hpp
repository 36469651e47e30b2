// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/audit/planar.hpp>
#include <optional>
#include <vector>

namespace limpet::audit {

/// The edge that leaves a vertex.
struct EdgePlace {
  std::size_t cycle = 0;
  std::size_t vertex = 0;
};

/// Two edges that meet where they must not.
struct Clash {
  EdgePlace first, second;
};

/// Finds two edges that meet in anything but the common vertex of consecutive edges, or nothing if there are
/// none: a touching vertex, an overlap and a spike are clashes. Every cycle must have at least three vertices
/// and no edge of zero length. O(n log n) in the total number of edges.
std::optional<Clash> find_clash(const std::vector<std::vector<Point>>& cycles);

}  // namespace limpet::audit
