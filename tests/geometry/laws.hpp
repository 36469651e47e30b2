// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "../expect_law.hpp"
#include "../generators/polygons.hpp"
#include "perimeters.hpp"
#include "whole_numbers.hpp"

/// What the tests of the numbered laws have in common.
namespace limpet::geometry {

using namespace properties;

/// A quarter turn or none, and a translation by up to 3 · 2^`reach` whole steps.
inline shapes::Map any_motion(int reach = 38) {
  shapes::Map m = one_of(2) ? shapes::kQuarterTurn : shapes::Map{};
  const Point2 by = power_of_two(0, reach) * small_point(3);
  m.x = by.x, m.y = by.y;
  return m;
}

inline Slot any_slot(const Polygon& p) {
  return Slot{static_cast<std::uint32_t>(whole(0, 999)) % static_cast<std::uint32_t>(p.slot_count())};
}

/// λ in grid steps: from hardly a step, through the size of the shapes, to what it is in the product.
inline double any_gap() { return one_of(3) == 2 ? power_of_two(1, 13) : static_cast<double>(whole(2, 60)); }

/// Some edges become shared ones. Returns their identities.
inline std::vector<EdgeId> share_some(Polygon& p) {
  std::vector<EdgeId> shared;
  for (auto n = whole(0, 3); n > 0; --n) {
    const Slot s = any_slot(p);
    p.set_shared(s, true);
    shared.push_back(p.node(s).edge);
  }
  return shared;
}

inline bool holds_shared(const Polygon& p, const std::vector<EdgeId>& ids) {
  std::vector<EdgeId> found;
  for (const auto& [s, edge] : all_edges(p))
    if (p.node(s).shared) found.push_back(edge);
  return std::all_of(ids.begin(), ids.end(),
                     [&](EdgeId id) { return std::find(found.begin(), found.end(), id) != found.end(); });
}

inline double exact_area(const Cycles& cycles) {
  return static_cast<double>(whole_numbers::twice_area(cycles)) / 2;
}

/// Does `part` reach to within so many steps of p, or hold it?
inline bool reaches(const Polygon& part, Point2 p, double steps) {
  return part.locate(p) != Polygon::Side::outside || distance_to(part, p) <= steps;
}

/// Is what `after` has more than the polygons it was made of within so many steps of them? Asked about some
/// points between its vertices.
inline bool adds_no_more_than(const Polygon& after, const std::vector<const Polygon*>& parts, double steps) {
  std::vector<Point2> vertices;
  for (const auto& cycle : after.boundary())
    for (const NewVertex& v : cycle) vertices.push_back(v.at);
  const auto any = [&] { return vertices[static_cast<std::size_t>(whole(0, 999)) % vertices.size()]; };
  for (int k = 0; k < 12; ++k) {
    const Point2 a = any(), b = any(), c = any();
    for (const Point2 p : {round_to_grid(0.5 * (a + b)), round_to_grid((1.0 / 3) * (a + b + c))}) {
      if (after.locate(p) == Polygon::Side::outside) continue;
      const auto near = [&](const Polygon* part) { return reaches(*part, p, steps); };
      if (std::none_of(parts.begin(), parts.end(), near)) return false;
    }
  }
  return true;
}

inline void expect_valid(const Polygon& p) { RC_ASSERT(whole_numbers::is_valid(p.boundary())); }

}  // namespace limpet::geometry
