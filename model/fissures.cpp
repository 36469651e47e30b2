// Copyright the limpet authors. GPL-3.0-or-later.
//
// Step 3 of the update: filling fissures in the perimeters of modified polygons (thesis §2.5).
#include <algorithm>

#include <limpet/geometry/fissure.hpp>

#include "fissures_internal.hpp"

namespace limpet::model::internal {
namespace {

bool fill(Complex& complex, Agenda& agenda, const Segment& s) {
  const PlacedEdges fresh = std::exchange(agenda.polygon(s.slot).fresh, {});
  if (fresh.empty()) return false;
  const DirtyRegion where = region_of(*s.polygon, fresh);
  auto [filled, difference] =
      complex.change_perimeter(s, true, [&](geometry::Polygon& perimeter, geometry::EdgeIds& ids) {
        return geometry::fill_fissures(perimeter, fresh, complex.setting().gap, ids, complex.rules().holes);
      });
  if (filled == 0) return false;
  complex.tell(s, std::move(difference));
  complex.description_changed(s, where);  // other segments may be nearer now
  return true;
}

}  // namespace

bool fill_modified(Complex& complex, Agenda& agenda) {
  bool any = false;
  for (const std::uint32_t slot : std::vector<std::uint32_t>(agenda.modified()))
    if (const Segment* s = complex.in_slot(slot); s && s->polygon && !s->initial())
      any |= fill(complex, agenda, *s);
  return any;
}

}  // namespace limpet::model::internal
