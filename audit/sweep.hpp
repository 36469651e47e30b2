// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/audit/planar.hpp>
#include <optional>
#include <vector>

namespace limpet::audit {

/// An edge, named by the vertex it leaves.
struct EdgePlace {
  std::size_t cycle = 0;
  std::size_t vertex = 0;
};

/// Two edges that meet where they must not.
struct Clash {
  EdgePlace first, second;
};

/// Finds two edges that meet other than consecutive edges at their common vertex; nothing if all cycles are
/// simple and disjoint. A touching vertex, an overlap and a spike (an edge that turns back along the one
/// before) are clashes. Precondition: every cycle has at least three vertices and no edge of zero length. A
/// plane sweep (Shamos and Hoey 1976): O(n log n) for n edges in all.
std::optional<Clash> find_clash(const std::vector<std::vector<Point>>& cycles);

}  // namespace limpet::audit
