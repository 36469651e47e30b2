// Copyright the limpet authors. GPL-3.0-or-later.
//
// Holes that are only chance gaps, where no sensor point happened to fall. At five points per λ² an empty
// disc wider than λ is not rare, and a perimeter may grow around it.
#include "voids_internal.hpp"

#include <algorithm>
#include <cmath>

#include <limpet/geometry/measure.hpp>

#include "series_internal.hpp"

namespace limpet::model::internal {
namespace {

/// Area of the polygon with these holes filled: the area that its points are spread over, if the holes are
/// chance gaps.
double area_with(const geometry::Polygon& perimeter, const std::vector<geometry::CycleId>& holes) {
  double area = geometry::area(perimeter);
  for (const geometry::CycleId id : holes) area -= geometry::signed_area(perimeter, perimeter.cycle(id));
  return area;
}

/// Is a hole shared all around? Then it is the footprint of something, however small.
bool all_shared(const geometry::Polygon& polygon, const geometry::Polygon::Cycle& cycle) {
  const auto vertices = polygon.vertices(cycle);
  return std::all_of(vertices.begin(), vertices.end(), [](const auto& v) { return v.shared; });
}

}  // namespace

/// An area in which n points are expected is empty with probability exp(−n). Its outline may start at any of
/// the m points, and go on from each vertex to any of the c points in the half disc of radius λ ahead: m·cᵏ
/// shapes. It may be a chance gap if the product of both is above 10⁻³.
bool empty_by_chance(double area, std::size_t k, std::int64_t m, double density, double gap) {
  const double choices = std::max(1.5707963 * density * gap * gap, 2.0);
  return density * area <
         natural_log(1000.0 * static_cast<double>(m)) + static_cast<double>(k) * natural_log(choices);
}

bool empty_by_chance(const Setting& setting, const Segment& s, double area, std::size_t k) {
  const auto m = s.count();
  if (m == 0) return false;
  return empty_by_chance(area, k, m, static_cast<double>(m) / s.polygon->perimeter.area(), setting.gap);
}

bool is_spur(const Setting& setting, double area, double depth) {
  return setting.rules().spurs && std::abs(area) < setting.gap / 2 * std::max(depth, 2 * setting.gap);
}

bool drop_chance_holes(Complex& complex, const Segment& s) {
  const geometry::Polygon& perimeter = s.polygon->perimeter;
  if (perimeter.hole_count() == 0 || s.count() == 0) return false;
  std::vector<geometry::CycleId> small;
  for (std::uint32_t i = 0; i < perimeter.cycles().size(); ++i) {
    const auto& cycle = perimeter.cycles()[i];
    if (cycle.size > 0 && cycle.hole && !all_shared(perimeter, cycle)) small.push_back(geometry::CycleId{i});
  }
  const auto m = s.count();
  geometry::Edit edit;
  // The density has to leave out the area of true holes, which are not known yet. So all holes start as
  // candidates; each one found to be true raises the density, which may show others to be true.
  for (std::size_t before = small.size() + 1; small.size() < before;) {
    before = small.size();
    const double density = static_cast<double>(m) / area_with(perimeter, small);
    std::erase_if(small, [&](geometry::CycleId id) {
      const auto& cycle = perimeter.cycle(id);
      return !empty_by_chance(-geometry::signed_area(perimeter, cycle), cycle.size, m, density,
                              complex.setting().gap);
    });
  }
  edit.removed_cycles = small;
  if (edit.removed_cycles.empty()) return false;
  const auto all_over = [&](const BoundaryDifference&) { return s.polygon->box; };
  const auto verdict = complex.change_perimeter(
      s, false, all_over,
      [&](geometry::Polygon& polygon, geometry::EdgeIds& ids) { return polygon.change(edit, ids); });
  return verdict == geometry::Verdict::valid;
}

}  // namespace limpet::model::internal
