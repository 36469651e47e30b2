// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cmath>
#include <ostream>
#include <string>

#include <limpet/geometry/judge.hpp>

#include "points.hpp"
#include "shapes.hpp"

/// Boundaries of polygons near to being none: a grid step from touching, collinear stretches, narrow inlets
/// and walls, holes beside holes; small, large (to 2^25 steps and to 2^40) and far from the origin.
namespace limpet::properties {

using geometry::NewVertex;
using shapes::Cycles;

/// A boundary, outer cycle first.
struct Boundary {
  Cycles cycles;
};

/// As text that can be put into a test.
inline std::ostream& operator<<(std::ostream& out, const Boundary& boundary) {
  const char* next = "{";
  for (const auto& cycle : boundary.cycles) {
    out << next << "cycle_of({";
    for (std::size_t i = 0; i < cycle.size(); ++i) out << (i ? ", " : "") << cycle[i].at;
    out << "})";
    next = ", ";
  }
  return out << '}';
}

namespace polygons_detail {

inline double some(std::int64_t low, std::int64_t high) { return static_cast<double>(whole(low, high)); }

inline std::vector<std::int64_t> list_of(std::size_t least, std::int64_t low, std::int64_t high) {
  auto list = *rc::gen::container<std::vector<std::int64_t>>(rc::gen::inRange(low, high + 1));
  if (list.size() > 24) list.resize(24);
  while (list.size() < least) list.push_back(low);
  return list;
}

/// A walk over cells, in the order of its steps.
inline Cycles walked_cells() {
  const auto steps = list_of(1, 0, 3);
  constexpr int kSide = 6;
  shapes::Cells cells(kSide + 2);
  int x = kSide / 2, y = kSide / 2;
  cells.at(x, y) = 1;
  for (const auto step : steps) {
    (step < 2 ? x : y) += step % 2 ? 1 : -1;
    x = std::min(std::max(x, 1), kSide), y = std::min(std::max(y, 1), kSide);
    cells.at(x, y) = 1;
  }
  return shapes::outline_of(cells, one_of(2) == 1);
}

/// Up to seven points on few places: seldom valid.
inline Cycles any_cycle() {
  Cycles cycles(1);
  for (auto n = whole(3, 7); n > 0; --n) cycles[0].push_back({small_point(4)});
  return cycles;
}

}  // namespace polygons_detail

inline constexpr int kShapes = 14;

/// A shape in small steps about the origin; seldom not valid.
inline Cycles small_shape(int kind) {
  using namespace polygons_detail;
  switch (kind) {
    case 0: {
      const double w = some(1, 10), h = some(1, 10);
      return {shapes::rectangle(0, 0, w, h)};
    }
    case 1: {
      const double length = some(1, 10000), rise = some(1, 3), lift = some(0, 3);
      return shapes::needle(length, rise, lift);
    }
    case 2: {
      const double wall = some(1, 4), bore = some(1, 9);
      return shapes::ring(wall, bore);
    }
    case 3: {
      const double wall = some(1, 4), bore = some(2, 9);
      return shapes::slit_ring(wall, bore, 1);
    }
    case 4: {
      const auto teeth = static_cast<int>(whole(1, 12));
      const double tooth = some(1, 4), slit = some(1, 4), depth = some(1, 40), spine = some(1, 3);
      return shapes::comb(teeth, tooth, slit, depth, spine);
    }
    case 5: {
      const auto turns = static_cast<int>(whole(1, 16));
      return shapes::spiral(turns, some(2, 5), 1);
    }
    case 6:
      return shapes::star(list_of(4, 1, 50));
    case 7: {
      const auto blades = static_cast<int>(whole(1, 12));
      const double notch = some(1, 200);
      return shapes::fan(blades, notch);
    }
    case 8:
      return shapes::staircase(static_cast<int>(whole(1, 16)));
    case 9: {
      const auto off = list_of(2, -1, 1);
      const double stride = some(1, 100), thickness = some(1, 3);
      return shapes::near_line(off, stride, thickness, one_of(2) == 1);
    }
    case 10: {
      const auto columns = static_cast<int>(whole(1, 4)), rows = static_cast<int>(whole(1, 4));
      const double hole = some(1, 6), wall = some(1, 3), border = some(1, 3);
      return shapes::sieve(columns, rows, hole, wall, border);
    }
    case 11: {
      const auto depth = static_cast<int>(whole(1, 4));
      const double wall = some(1, 3), slit = some(1, 3);
      return shapes::nest(depth, wall, slit);
    }
    case 12:
      return walked_cells();
    default:
      return any_cycle();
  }
}

/// A map with whole coefficients that are not large; `reach` bounds what it makes of a small shape.
inline shapes::Map small_map() {
  const auto k = static_cast<double>(whole(1, 40));
  switch (one_of(4)) {
    case 1:
      return shapes::kQuarterTurn;
    case 2:
      return {1, k, 0, 1};  // makes near-parallel lines
    case 3:
      return {k, -1, 1, k};
    default:
      return {};
  }
}

/// A boundary that may be invalid by a step: shape, map, regime, and a few vertices moved by a step.
inline Boundary any_boundary() {
  Boundary boundary{small_shape(one_of(kShapes))};
  shapes::map_all(boundary.cycles, small_map());
  const int regime = one_of(5);
  geometry::Box2 box;
  for (const auto& cycle : boundary.cycles)
    for (const NewVertex& v : cycle) box.add(v.at);
  const double reach = std::max({1.0, -box.low.x, -box.low.y, box.high.x, box.high.y});
  double scale = 1;
  const double room = regime == 2 ? 0x1p25 : regime == 3 ? 0x1p40 : 1;
  for (const double largest = power_of_two(0, 40); 2 * scale * reach <= room && scale < largest;) scale *= 2;
  const Point2 place = regime == 4 ? power_of_two(10, 39) * small_point(1) : Point2{};
  shapes::map_all(boundary.cycles, {scale, 0, 0, scale, place.x, place.y});
  for (auto moves = whole(0, 3); moves > 0; --moves) {
    auto& cycle = boundary.cycles[static_cast<std::size_t>(whole(0, 99)) % boundary.cycles.size()];
    if (cycle.empty()) continue;
    Point2& p = cycle[static_cast<std::size_t>(whole(0, 99)) % cycle.size()].at;
    p = p + small_point(1);
  }
  return boundary;
}

/// Boundaries, many of them not valid.
inline rc::Gen<Boundary> boundaries() { return rc::gen::exec(any_boundary); }

/// Valid boundaries.
inline rc::Gen<Boundary> polygons() {
  return rc::gen::suchThat(boundaries(), [](const Boundary& b) {
    return geometry::judge_cycles(b.cycles) == geometry::Verdict::valid;
  });
}

/// Two polygons that meet, touch or nearly do: often in vertices, along edges or along lines.
struct Pair {
  Boundary a, b;
};
inline std::ostream& operator<<(std::ostream& out, const Pair& pair) {
  return out << pair.a << ",\n" << pair.b;
}

inline rc::Gen<Pair> pairs() {
  const auto pair = rc::gen::exec([] {
    Pair result{*polygons(), {}};
    result.b = one_of(3) == 0 ? result.a : *polygons();
    const auto vertex = [](const Boundary& b) {
      const auto& cycle = b.cycles[static_cast<std::size_t>(whole(0, 99)) % b.cycles.size()];
      return cycle[static_cast<std::size_t>(whole(0, 99)) % cycle.size()].at;
    };
    // In place, or with a vertex at one of the other's, a few steps beside it or part of the way to the next.
    const int how = one_of(5);
    if (how == 0) return result;
    const Point2 from = vertex(result.b), to = vertex(result.a);
    Point2 by = to - from;
    if (how == 2) by = by + small_point(2);
    if (how == 3) by = by + small_point(40);
    if (how == 4) {
      const Point2 half = 0.5 * (vertex(result.a) - to);
      by = by + Point2{std::floor(half.x), std::floor(half.y)};
    }
    shapes::map_all(result.b.cycles, shapes::translation(by));
    return result;
  });
  return rc::gen::suchThat(
      pair, [](const Pair& p) { return geometry::judge_cycles(p.b.cycles) == geometry::Verdict::valid; });
}

/// A grid point that tells: at a vertex, on an edge, up to `reach` steps beside one, or near the middle.
inline Point2 telling_point(const Cycles& cycles, std::int64_t reach) {
  const auto& cycle = cycles[static_cast<std::size_t>(whole(0, 99)) % cycles.size()];
  const auto i = static_cast<std::size_t>(whole(0, 999)) % cycle.size();
  const Point2 a = cycle[i].at, b = cycle[(i + 1) % cycle.size()].at;
  const double t = static_cast<double>(about_zero(12)) / 8;
  const Point2 p = a + t * (b - a);
  return Point2{std::floor(p.x), std::floor(p.y)} + small_point(reach);
}

}  // namespace limpet::properties
