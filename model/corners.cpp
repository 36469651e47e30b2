// Copyright the limpet authors. GPL-3.0-or-later.
//
// Step 5 of the update: forming corner vertices (thesis §2.7) around a ring of segments S₀…Sₙ, n ≥ 2, each
// the neighbour of the next: on all of them or on none.
#include <utility>

#include "corners_internal.hpp"

namespace limpet::model::internal {
namespace {

using geometry::EdgeId;

/// Forms the corner, if it can be and is not there already.
bool form_corner(Engine& e, Ring& ring) {
  const CornerEdits corner = edits_for(e, ring, e.sharing);
  if (corner.refusal != Refusal::none || corner.formed_already) return false;
  const auto& parts = ring.parts;
  Change formed{Change::Kind::corner_formed, parts[0].segment->id, parts[1].segment->id, {}, {}};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    geometry::Polygon& perimeter = e.at(parts[i].segment->slot).polygon->perimeter;
    perimeter.commit(corner.edits[i], e.edge_ids);
    formed.edges.push_back(perimeter.node(parts[i].before).edge);
  }
  for (const RingPart& part : parts) perimeter_changed(e, e.at(part.segment->slot));
  e.changes.push_back(std::move(formed));
  return true;
}

bool form_corners(Engine& e, Segment& s) {
  bool any = false;
  const std::vector<EdgeId> edges = std::exchange(s.polygon->corners_due, {});
  for (const EdgeId edge : edges) {
    const auto entry = e.shared.find(edge.value);
    if (entry == e.shared.end() || entry->second.segment != s.slot) continue;
    Ring ring = ring_from(e, s, entry->second.slot);
    any |= form_corner(e, ring);
  }
  return any;
}

}  // namespace

bool form_corners_of_modified(Engine& e) {
  const Turn turn =
      polygons_of(e, e.modified, [](const PolygonPart& part) { return !part.corners_due.empty(); });
  bool any = false;
  for (const auto& [id, slot] : turn)
    if (Segment* s = e.find(id, slot)) any |= form_corners(e, *s);
  return any;
}

}  // namespace limpet::model::internal
