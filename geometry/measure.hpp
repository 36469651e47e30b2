// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/geometry/polygon.hpp>

namespace limpet::geometry {

/// Signed area of a cycle, in grid steps squared: positive when it is anticlockwise. In double arithmetic.
inline double signed_area(const Polygon& polygon, const Polygon::Cycle& cycle) {
  double twice = 0;
  const Point2 origin = polygon.at(cycle.first);
  Slot s = cycle.first;
  for (std::uint32_t i = 0; i < cycle.size; ++i, s = polygon.next(s))
    twice += cross(polygon.at(s) - origin, polygon.end(s) - origin);
  return twice / 2;
}

/// Area of the polygon without its holes, summed over all edges; Polygon::area() is kept incrementally.
inline double area(const Polygon& polygon) {
  double sum = 0;
  for (const auto& cycle : polygon.cycles())
    if (cycle.size > 0) sum += signed_area(polygon, cycle);
  return sum;
}

}  // namespace limpet::geometry
