// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include <boost/multiprecision/cpp_int.hpp>

#include <limpet/geometry/types.hpp>

#include "../generators/shapes.hpp"

/// What the predicates and the judge decide, from the definitions, in whole numbers. Shares nothing with
/// geometry/ but its types.
namespace limpet::whole_numbers {

using geometry::Box2;
using geometry::Point2;
using shapes::Cycles;

__extension__ typedef __int128 Int128;
using BigInt = boost::multiprecision::cpp_int;

/// x · 2^1074, which is whole for every finite double.
inline BigInt big(double x) {
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
  const int shift = exponent - 53 + 1074;
  return shift >= 0 ? BigInt(mantissa) << shift : BigInt(mantissa >> -shift);  // only zeros leave
}
inline Int128 small(double x) { return static_cast<Int128>(x); }
inline bool is_small(double x) { return x == std::floor(x) && std::abs(x) <= 0x1p60; }

template <class Number>
int sign_of_cross(const Number& ax, const Number& ay, const Number& bx, const Number& by) {
  const Number left = ax * by, right = ay * bx;
  return left > right ? 1 : left < right ? -1 : 0;
}

/// orientation(). Names differ from those of geometry/, which arguments would find.
inline int turn(Point2 p, Point2 q, Point2 r) {
  bool all_small = true;
  for (const double x : {p.x, p.y, q.x, q.y, r.x, r.y}) all_small &= is_small(x);
  if (all_small)
    return sign_of_cross<Int128>(small(q.x) - small(p.x), small(q.y) - small(p.y), small(r.x) - small(p.x),
                                 small(r.y) - small(p.y));
  return sign_of_cross<BigInt>(big(q.x) - big(p.x), big(q.y) - big(p.y), big(r.x) - big(p.x),
                               big(r.y) - big(p.y));
}

inline bool on_segment(Point2 a, Point2 b, Point2 p) {
  return geometry::box_of(a, b).contains(p) && turn(a, b, p) == 0;
}

inline bool meet(Point2 a, Point2 b, Point2 c, Point2 d) {
  if (on_segment(a, b, c) || on_segment(a, b, d) || on_segment(c, d, a) || on_segment(c, d, b)) return true;
  return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

/// The same ray: collinear with the apex, and not on opposite sides of it.
inline bool overlap(Point2 apex, Point2 p, Point2 q) {
  return turn(apex, p, q) == 0 && (on_segment(apex, p, q) || on_segment(apex, q, p));
}

/// +1 inside, 0 on an edge, -1 outside: by the winding number.
inline int locate(const Cycles& cycles, Point2 p) {
  int winding = 0;
  for (const auto& cycle : cycles)
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const Point2 a = cycle[i].at, b = cycle[(i + 1) % cycle.size()].at;
      if (on_segment(a, b, p)) return 0;
      if (a.y <= p.y && b.y > p.y && turn(a, b, p) > 0) ++winding;
      if (b.y <= p.y && a.y > p.y && turn(a, b, p) < 0) --winding;
    }
  return winding != 0 ? 1 : -1;
}

/// Whole coordinates below 2^60 only.
inline Int128 twice_area(const std::vector<shapes::NewVertex>& cycle) {
  Int128 sum = 0;
  const Point2 o = cycle.empty() ? Point2{} : cycle[0].at;
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const Point2 a = cycle[i].at, b = cycle[(i + 1) % cycle.size()].at;
    sum += (small(a.x) - small(o.x)) * (small(b.y) - small(o.y)) -
           (small(a.y) - small(o.y)) * (small(b.x) - small(o.x));
  }
  return sum;
}
inline Int128 twice_area(const Cycles& cycles) {
  Int128 sum = 0;
  for (const auto& cycle : cycles) sum += twice_area(cycle);
  return sum;
}

/// Edges of all cycles against each other: they meet in the common vertex of consecutive ones alone.
inline bool is_simple(const Cycles& cycles) {
  struct Edge {
    Point2 a, b;
    std::size_t cycle, place, size;
  };
  std::vector<Edge> edges;
  for (std::size_t c = 0; c < cycles.size(); ++c)
    for (std::size_t i = 0; i < cycles[c].size(); ++i)
      edges.push_back({cycles[c][i].at, cycles[c][(i + 1) % cycles[c].size()].at, c, i, cycles[c].size()});
  for (std::size_t j = 0; j < edges.size(); ++j) {
    const Edge& f = edges[j];
    if (f.size < 3 || f.a == f.b) return false;
    for (std::size_t i = 0; i < j; ++i) {
      const Edge& e = edges[i];
      if (!geometry::box_of(e.a, e.b).meets(geometry::box_of(f.a, f.b))) continue;
      const bool follows = e.cycle == f.cycle && (e.place + 1) % e.size == f.place,
                 leads = e.cycle == f.cycle && (f.place + 1) % f.size == e.place;
      if (follows ? on_segment(e.a, e.b, f.b) || on_segment(f.a, f.b, e.a)
          : leads ? on_segment(f.a, f.b, e.b) || on_segment(e.a, e.b, f.a)
                  : meet(e.a, e.b, f.a, f.b))
        return false;
    }
  }
  return true;
}

/// The invariant of a Polygon.
inline bool is_valid(const Cycles& cycles) {
  if (cycles.empty() || !is_simple(cycles)) return false;
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    if ((twice_area(cycles[i]) > 0) != (i == 0)) return false;
    for (std::size_t j = 0; j < cycles.size() && i > 0; ++j)
      if (i != j && (locate({cycles[j]}, cycles[i][0].at) > 0) != (j == 0)) return false;
  }
  return true;
}

}  // namespace limpet::whole_numbers
