// Copyright the limpet authors. GPL-3.0-or-later.
//
// Step 5 of the update: forming corner vertices (thesis §2.7). Around a ring of segments S₀…Sₙ, n ≥ 2, each
// of which is a neighbour of the next, the corner is formed on all of them or on none.
#include <utility>

#include "corners_internal.hpp"
#include "sharing_internal.hpp"

namespace limpet::model::internal {
namespace {

using geometry::EdgeId;

/// Forms the corner, unless it is refused or there already. Returns whether it was formed.
bool form_corner(Complex& complex, Ring& ring, const SharingReach& reach) {
  CornerEdits corner = edits_for(complex, ring, reach);
  if (corner.refusal != Refusal::none || corner.formed_already) return false;
  const auto& parts = ring.parts;
  Transaction transaction;
  std::vector<EdgeId> edges;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    transaction.edits.emplace_back(parts[i].segment->slot, std::move(corner.edits[i]));
    edges.push_back(parts[i].segment->polygon->perimeter.node(parts[i].before).edge);
  }
  complex.commit_judged(transaction);
  complex.tell_corner(*parts[0].segment, *parts[1].segment, edges);
  return true;
}

bool form_corners(Complex& complex, Agenda& agenda, const Segment& s) {
  bool any = false;
  const std::vector<EdgeId> edges = std::exchange(agenda.polygon(s.slot).corners_due, {});
  for (const EdgeId edge : edges) {
    const EdgePlace* place = complex.edges().find(edge);
    if (!place || !place->partner || place->segment != s.slot) continue;
    Ring ring = ring_from(complex, s, place->slot);
    any |= form_corner(complex, ring, agenda.sharing);
  }
  return any;
}

}  // namespace

bool form_corners_of_modified(Complex& complex, Agenda& agenda) {
  const Turn turn = polygons_of(complex, agenda.modified(), [&](const Segment& s) {
    return !agenda.polygon(s.slot).corners_due.empty();
  });
  bool any = false;
  for (const auto& [id, slot] : turn) {
    if (agenda.stopped()) break;
    if (const Segment* s = complex.find(id, slot)) any |= form_corners(complex, agenda, *s);
  }
  return any;
}

}  // namespace limpet::model::internal
