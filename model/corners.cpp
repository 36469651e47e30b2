// Copyright the limpet authors. GPL-3.0-or-later.
//
// Step 5 of the update: forming corner vertices (thesis §2.7). Around a ring of segments S₀…Sₙ, n ≥ 2, each
// of which is a neighbour of the next, the corner is formed on all of them or on none.
#include <algorithm>
#include <utility>

#include "corners_internal.hpp"
#include "sharing_internal.hpp"

namespace limpet::model::internal {
namespace {

using geometry::EdgeId;

/// Forms the corner, unless it is there already. Precondition: nothing refuses it.
bool form(Complex& complex, const Ring& ring, CornerEdits&& corner) {
  if (corner.formed_already) return false;
  const auto& parts = ring.parts;
  Transaction transaction;
  std::vector<EdgeId> edges;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    transaction.edits.emplace_back(parts[i].segment->slot, std::move(corner.edits[i]));
    edges.push_back(parts[i].segment->polygon->perimeter.node(parts[i].before).edge);
  }
  complex.commit_judged(transaction);
  complex.tell_corner(*parts[0].segment, *parts[1].segment, edges);
  complex.keep_ends_in_place(transaction);
  return std::all_of(edges.begin(), edges.end(), [&](EdgeId edge) { return complex.edges().shared(edge); });
}

/// Where four planes meet in one place, two opposite ones may share an edge that is shorter than what their
/// corners can keep. It is given up for a corner of all four. Returns whether that was formed.
bool form_without_short(Complex& complex, const Ring& ring, const SharingReach& reach) {
  for (const RingPart& part : ring.parts) {
    const auto& perimeter = part.segment->polygon->perimeter;
    const geometry::Slot before = perimeter.prev(part.before);
    const double shortest =
        kShortCorner * complex.setting().scale_at(part.segment->polygon->position(part.before)).gap;
    const double length2 = squared_length(perimeter.end(part.before) - perimeter.at(part.before));
    if (length2 > shortest * shortest || !perimeter.node(before).shared) continue;
    const EdgeId edge = perimeter.node(part.before).edge, copy = complex.edges().at(edge).partner;
    bool formed = false;
    complex.with_ends_apart([&] {
      complex.unshare(edge);
      Ring whole = ring_from(complex, *part.segment, before);
      CornerEdits corner = edits_for(complex, whole, reach);
      formed = corner.refusal == Refusal::none && form(complex, whole, std::move(corner));
      if (!formed) complex.share_open(edge, copy);
    });
    return formed;
  }
  return false;
}

/// Forms the corner, unless it is refused or there already. Returns whether it was formed.
bool form_corner(Complex& complex, const Agenda& agenda, Ring& ring) {
  CornerEdits corner = edits_for(complex, ring, agenda.sharing);
  if (corner.refusal == Refusal::none) return form(complex, ring, std::move(corner));
  return corner.refusal == Refusal::corner_turns && agenda.finishing &&
         form_without_short(complex, ring, agenda.sharing);
}

bool form_corners(Complex& complex, Agenda& agenda, const Segment& s) {
  bool any = false;
  const std::vector<EdgeId> edges = std::exchange(agenda.polygon(s.slot).corners_due, {});
  for (const EdgeId edge : edges) {
    const EdgePlace* place = complex.edges().find(edge);
    if (!place || !place->partner || place->segment != s.slot) continue;
    Ring ring = ring_from(complex, s, place->slot);
    any |= form_corner(complex, agenda, ring);
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
