// Copyright the limpet authors. GPL-3.0-or-later.
//
// Step 3 of the update: filling fissures in the perimeters of modified polygons (thesis §2.5).
#include <algorithm>

#include <limpet/geometry/fissure.hpp>

#include "engine_internal.hpp"

namespace limpet::model::internal {
namespace {

bool fill(Engine& e, Segment& s) {
  PolygonPart& part = *s.polygon;
  if (part.fresh.empty()) return false;
  const auto fresh = std::exchange(part.fresh, {});
  const Places where = places_of(part, fresh);
  if (geometry::fill_fissures(part.perimeter, fresh, e.gap, e.edge_ids, e.rules().holes) == 0) return false;
  if (auto removed = part.perimeter.take_removed(); !removed.empty())
    e.changes.push_back({Change::Kind::edges_removed, {}, {}, s.id, std::move(removed)});
  description_changed(e, s, where);  // other segments may be nearer now
  return true;
}

}  // namespace

bool fill_modified(Engine& e) {
  bool any = false;
  for (const std::uint32_t slot : e.modified)
    if (e.segments[slot] && e.segments[slot]->polygon && !e.at(slot).initial()) any |= fill(e, e.at(slot));
  return any;
}

}  // namespace limpet::model::internal
