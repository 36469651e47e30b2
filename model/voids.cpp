// Copyright the limpet authors. GPL-3.0-or-later.
//
// Holes that are only chance gaps, where no sensor point happened to fall. At five points per λ² an empty
// disc wider than λ is not rare, and a perimeter may grow around it.
#include "voids_internal.hpp"

#include <algorithm>
#include <cmath>

#include <limpet/geometry/measure.hpp>

#include "chance_internal.hpp"

namespace limpet::model::internal {
namespace {

/// Is a hole shared all around? Then it is the footprint of something, however small.
bool all_shared(const geometry::Polygon& polygon, const geometry::Polygon::Cycle& cycle) {
  const auto vertices = polygon.vertices(cycle);
  return std::all_of(vertices.begin(), vertices.end(), [](const auto& v) { return v.shared; });
}

/// What closing a hole adds.
Addition filling(const PolygonPart& part, const geometry::Polygon::Cycle& hole) {
  std::vector<geometry::Point2> outline;
  for (const auto& vertex : part.perimeter.vertices(hole)) outline.push_back(vertex.at);
  return addition_on(part, outline);
}

}  // namespace

bool is_spur(const Rules& rules, double gap, double area, double depth) {
  return rules.spurs && std::abs(area) < gap / 2 * std::max(depth, 2 * gap);
}

bool drop_chance_holes(Complex& complex, const Segment& s) {
  const geometry::Polygon& perimeter = s.polygon->perimeter;
  if (perimeter.hole_count() == 0 || s.count() == 0) return false;
  std::vector<geometry::CycleId> small;
  for (std::uint32_t i = 0; i < perimeter.cycles().size(); ++i) {
    const auto& cycle = perimeter.cycles()[i];
    if (cycle.size > 0 && cycle.hole && !all_shared(perimeter, cycle)) small.push_back(geometry::CycleId{i});
  }
  std::erase_if(small, [&](geometry::CycleId id) {
    return !chance_explains(complex, s, filling(*s.polygon, perimeter.cycle(id)));
  });
  geometry::Edit edit;
  edit.removed_cycles = small;
  if (edit.removed_cycles.empty()) return false;
  const auto all_over = [&](const BoundaryDifference&) { return s.polygon->box; };
  const auto verdict = complex.change_perimeter(
      s, false, all_over,
      [&](geometry::Polygon& polygon, geometry::EdgeIds& ids) { return polygon.change(edit, ids); });
  if (verdict == geometry::Verdict::valid) complex.note_addition(s);
  return verdict == geometry::Verdict::valid;
}

}  // namespace limpet::model::internal
