// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <algorithm>
#include <cmath>

#include <limpet/audit/planar.hpp>
#include <limpet/audit/sweep.hpp>
#include <limpet/geometry/polygon.hpp>

#include "../tests/geometry/perimeter_shapes.hpp"

/// What is asked of a boundary, besides judge_cycles().
namespace limpet::benchmarks {

using geometry::Polygon;
using shapes::Cycles;
using shapes::NewVertex;

inline Cycles cycles_of(const Polygon& p) { return p.boundary(); }

inline double area_of(const Cycles& cycles) {
  double twice = 0;
  for (const auto& c : cycles)
    for (std::size_t i = 0; i < c.size(); ++i)
      twice += cross(c[i].at - c[0].at, c[(i + 1) % c.size()].at - c[0].at);
  return twice / 2;
}

inline double length_of(const Cycles& cycles) {
  double length = 0;
  for (const auto& c : cycles)
    for (std::size_t i = 0; i < c.size(); ++i)
      length += std::sqrt(squared_length(c[(i + 1) % c.size()].at - c[i].at));
  return length;
}

inline bool same(const Cycles& a, const Cycles& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& c, const auto& d) {
    return std::equal(c.begin(), c.end(), d.begin(), d.end(), [](const NewVertex& v, const NewVertex& w) {
      return v.at == w.at && v.edge == w.edge && v.shared == w.shared;
    });
  });
}

/// The audit's view, which shares no code with geometry/.
inline bool audit_accepts(const Cycles& cycles) {
  std::vector<std::vector<audit::Point>> rings;
  for (const auto& c : cycles) {
    if (c.size() < 3) return false;
    std::vector<audit::Point> ring;
    for (const NewVertex& v : c) ring.push_back({v.at.x, v.at.y});
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (ring[i] == ring[(i + 1) % ring.size()]) return false;
    rings.push_back(std::move(ring));
  }
  if (rings.empty() || audit::find_clash(rings)) return false;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const auto area = audit::twice_area(rings[i]);
    if (area.sign() != (i == 0 ? 1 : -1)) return false;
    for (std::size_t j = 0; j < rings.size(); ++j)
      if (i > 0 && i != j && (audit::side_of(rings[i][0], rings[j]) == audit::Side::kInside) != (j == 0))
        return false;
  }
  return true;
}

}  // namespace limpet::benchmarks
