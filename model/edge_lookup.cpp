// Copyright the limpet authors. GPL-3.0-or-later.
#include "edge_lookup_internal.hpp"

namespace limpet::model::internal {

const Segment* find_segment(const Engine& e, SegmentId id) {
  const auto entry = e.slot_of.find(id.value);
  return entry == e.slot_of.end() ? nullptr : &e.at(entry->second);
}

std::optional<EdgePlace> find_edge(const Engine& e, geometry::EdgeId edge) {
  if (!edge) return std::nullopt;
  if (const auto shared = e.shared.find(edge.value); shared != e.shared.end())
    return EdgePlace{shared->second.segment, shared->second.slot, shared->second.partner};
  for (const auto& s : e.segments) {
    if (!s || !s->polygon) continue;
    const geometry::Polygon& perimeter = s->polygon->perimeter;
    for (std::uint32_t i = 0; i < perimeter.slot_count(); ++i)
      if (perimeter.node(geometry::Slot{i}).edge == edge) return EdgePlace{s->slot, geometry::Slot{i}, {}};
  }
  return std::nullopt;
}

std::span<const geometry::EdgeId> shared_edges(const Segment& polygon) { return polygon.polygon->shared; }

}  // namespace limpet::model::internal
