// Copyright the limpet authors. GPL-3.0-or-later.
//
// Holes that are only places where by chance no sensor point fell. At five points per λ² an empty disc wider
// than λ is no rarity, and a perimeter grows around it.
#include <limpet/geometry/measure.hpp>

#include "engine_internal.hpp"

namespace limpet::model::internal {
namespace {

/// With n points expected in it, a hole is empty by chance with probability exp(−n), and there are at most m
/// places for one among m points. The smallest n for which m·exp(−n/2) ≤ 10⁻³; the half allows for a scan
/// half as dense there as on average.
double significant_count(std::int64_t m) {
  double expected = 1000.0 * static_cast<double>(m), n = 0;
  for (; expected > 1; n += 2) expected /= 2.718281828459045;
  return n;
}

bool any_shared(const geometry::Polygon& polygon, const geometry::Polygon::Cycle& cycle) {
  const auto vertices = polygon.vertices(cycle);
  return std::any_of(vertices.begin(), vertices.end(), [](const auto& v) { return v.shared; });
}

}  // namespace

bool drop_chance_holes(Engine& e, Segment& s) {
  geometry::Polygon& perimeter = s.polygon->perimeter;
  if (perimeter.hole_count() == 0 || s.moments.count() == 0) return false;
  const double density = static_cast<double>(s.moments.count()) / geometry::area(perimeter);
  const double needed = significant_count(s.moments.count());
  geometry::Edit edit;
  for (std::uint32_t i = 0; i < perimeter.cycles().size(); ++i) {
    const auto& cycle = perimeter.cycles()[i];
    if (cycle.size == 0 || !cycle.hole || any_shared(perimeter, cycle)) continue;
    if (-density * geometry::signed_area(perimeter, cycle) < needed)
      edit.removed_cycles.push_back(geometry::CycleId{i});
  }
  if (edit.removed_cycles.empty() || perimeter.judge(edit) != geometry::Verdict::valid) return false;
  perimeter.commit(edit, e.edge_ids);
  e.changes.push_back({Change::Kind::edges_removed, {}, {}, s.id, perimeter.take_removed()});
  description_changed(e, s, s.polygon->box);
  return true;
}

}  // namespace limpet::model::internal
