// Copyright the limpet authors. GPL-3.0-or-later.
//
// Unions against CGAL's own Boolean set operations, which forget where an edge came from but share no code.
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <limpet/geometry/unite.hpp>

#include "perimeters.hpp"

namespace limpet::geometry {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Ring = CGAL::Polygon_2<Kernel>;
using Region = CGAL::Polygon_with_holes_2<Kernel>;

Region region_of(const Polygon& p) {
  std::vector<Ring> rings;
  for (const auto& c : p.boundary()) {
    Ring& ring = rings.emplace_back();
    for (const NewVertex& v : c) ring.push_back({v.at.x, v.at.y});
  }
  return Region(rings.front(), rings.begin() + 1, rings.end());
}

double area_of(const Region& region) {
  Kernel::FT sum = region.outer_boundary().area();
  for (auto h = region.holes_begin(); h != region.holes_end(); ++h) sum += h->area();
  return CGAL::to_double(sum);
}

double area_of_common_part(const Polygon& a, const Polygon& b) {
  std::vector<Region> parts;
  CGAL::intersection(region_of(a), region_of(b), std::back_inserter(parts));
  double sum = 0;
  for (const Region& part : parts) sum += area_of(part);
  return sum;
}

/// A polygon that often shares vertices, edges or lines with the other.
Polygon beside(const Polygon& a, Random& random, EdgeIds& ids, double scale) {
  for (;;) {
    Cycles cycles = random.chance(0.3) ? a.boundary() : shapes::raw_shape(random);
    shapes::Map map = random.chance(0.3) ? shapes::Map{} : shapes::random_map(random, scale, 0);
    const Point2 to = telling_point(random, a, 2), from = map(cycles[0][random.bits() % cycles[0].size()].at);
    if (random.chance(0.8)) map.x = to.x - from.x, map.y = to.y - from.y;
    shapes::map_all(cycles, map);
    for (auto& c : cycles)
      for (NewVertex& v : c) v.edge = {};
    if (auto p = Polygon::from_cycles(cycles, ids)) return *std::move(p);
  }
}

TEST(UniteArea, IsTheSumLessTheCommonPart) {
  int done = 0, refused = 0;
  for (std::uint64_t seed = 1; seed <= 600; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    EdgeIds ids;
    const double scale = random.scale(20, 1e5);
    Polygon a = random_polygon(random, ids, scale);
    const Polygon before = a, b = beside(a, random, ids, scale);
    const double common = area_of_common_part(a, b);
    if (common <= 0) continue;
    const double wanted = area(a) + area(b) - common;
    std::size_t attempts = 0;
    if (!unite(a, b, 3, ids, &attempts)) {  // so narrow a gap that no hole of any size collapses
      ++refused;
      ASSERT_TRUE(same_boundary(before, a));
      continue;
    }
    ++done;
    ASSERT_EQ(judge_polygon(a), Verdict::valid);
    // Vertices are rounded by half a step, dropped within two, moved by up to two (at this gap).
    const double slack = (attempts == 1 ? 3 : 6) * (perimeter(before) + perimeter(b));
    ASSERT_NEAR(area(a), wanted, slack)
        << "attempt " << attempts << "\na " << shown(before) << "\nb " << shown(b) << "\nunion " << shown(a);
    expect_identities_hold(before, a);
    if (HasFailure()) return;
  }
  EXPECT_GT(done, 300);
  EXPECT_LT(refused * 10, done);
}

}  // namespace
}  // namespace limpet::geometry
