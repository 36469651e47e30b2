// Copyright the limpet authors. GPL-3.0-or-later.
//
// Step 3 of the update: filling fissures in the perimeters of modified polygons (thesis §2.5).
#include <utility>

#include <limpet/geometry/fissure.hpp>

#include "chance_internal.hpp"
#include "fissures_internal.hpp"

namespace limpet::model::internal {
namespace {

bool fill(Complex& complex, Agenda& agenda, const Segment& s) {
  const PlacedEdges fresh = std::exchange(agenda.polygon(s.slot).fresh, {});
  if (fresh.empty()) return false;
  const DirtyRegion where = region_of(*s.polygon, fresh);
  const auto at_fresh_edges = [&](const BoundaryDifference&) {
    return DirtyRegion(where);
  };  // others may be nearer now
  // After additions the perimeter is not where the readings left it: a gap may be narrow because both of its
  // sides were added.
  geometry::MayFill may_fill;
  if (s.polygon->felt && !s.polygon->all_felt())
    may_fill = [&](std::span<const geometry::Point2> region) {
      return chance_explains(complex, s, addition_on(*s.polygon, region));
    };
  const Setting& setting = complex.setting();
  const PolygonPart& part = *s.polygon;
  const geometry::Gap gap =
      setting.resolution_grows()
          ? geometry::Gap([&](geometry::Point2 p) { return setting.scale_at(part.at(p)).gap; },
                          setting.largest_scale(part.box).gap)
          : setting.least.gap;
  const auto filled = complex.change_perimeter(
      s, true, at_fresh_edges, [&](geometry::Polygon& perimeter, geometry::EdgeIds& ids) {
        return geometry::fill_fissures(perimeter, fresh, gap, ids, complex.rules().holes, may_fill);
      });
  return filled > 0;
}

}  // namespace

bool fill_modified(Complex& complex, Agenda& agenda) {
  bool any = false;
  for (std::size_t i = 0; i < agenda.modified().size() && !agenda.stopped();
       ++i)  // by index: marking more would be safe
    if (const Segment* s = complex.in_slot(agenda.modified()[i]); s && s->polygon && !s->initial())
      any |= fill(complex, agenda, *s);
  return any;
}

}  // namespace limpet::model::internal
