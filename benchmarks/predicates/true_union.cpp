// Copyright the limpet authors. GPL-3.0-or-later.
//
// The only file here that includes CGAL.
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>

#include "union_answers.hpp"

namespace limpet::benchmarks {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Ring = CGAL::Polygon_2<Kernel>;
using ExactRegion = CGAL::Polygon_with_holes_2<Kernel>;

ExactRegion exact_region_of(const shapes::Cycles& cycles) {
  std::vector<Ring> rings;
  for (const auto& cycle : cycles) {
    Ring& ring = rings.emplace_back();
    for (const auto& v : cycle) ring.push_back({v.at.x, v.at.y});
  }
  return {rings[0], rings.begin() + 1, rings.end()};
}

double length_of(const Ring& ring) {
  double length = 0;
  for (auto e = ring.edges_begin(); e != ring.edges_end(); ++e)
    length += std::sqrt(CGAL::to_double(e->squared_length()));
  return length;
}

}  // namespace

TrueUnion true_union(const cases::PerimeterCase& pair) {
  CGAL::Polygon_set_2<Kernel> set(exact_region_of(pair.start));
  set.join(exact_region_of(pair.steps[0].other));
  std::vector<ExactRegion> regions;
  set.polygons_with_holes(std::back_inserter(regions));
  TrueUnion result;
  result.components = static_cast<int>(regions.size());
  Kernel::FT area = 0;
  for (const ExactRegion& region : regions) {
    area += region.outer_boundary().area();
    for (auto hole = region.holes_begin(); hole != region.holes_end(); ++hole) {
      area += hole->area();  // negative
      const double size = -CGAL::to_double(hole->area());
      if (size <= pair.gap * length_of(*hole) / 2) result.droppable += size;
    }
  }
  result.area = CGAL::to_double(CGAL::exact(area));
  return result;
}

}  // namespace limpet::benchmarks
