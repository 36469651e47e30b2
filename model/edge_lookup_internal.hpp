// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <optional>
#include <span>

#include "engine_internal.hpp"

/// Where segments and edges are, by their identities alone.
namespace limpet::model::internal {

/// None when there is no such segment.
const Segment* find_segment(const Engine&, SegmentId);

struct EdgePlace {
  std::uint32_t segment = 0;  ///< slot of its segment
  geometry::Slot slot = geometry::kNoSlot;
  geometry::EdgeId partner;  ///< the other copy of a shared edge; none: it is open
};

/// Nothing when there is no such edge. Quick for shared edges; for an open one all perimeters are looked at.
std::optional<EdgePlace> find_edge(const Engine&, geometry::EdgeId);
/// The edges of a polygon that are shared, ascending.
std::span<const geometry::EdgeId> shared_edges(const Segment& polygon);

}  // namespace limpet::model::internal
