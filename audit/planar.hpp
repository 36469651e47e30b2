// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/audit/exact.hpp>
#include <span>

/// Exact planar predicates on finite doubles. Nothing here ever rounds a decision.
namespace limpet::audit {

struct Point {
  double x = 0, y = 0;
  friend bool operator==(const Point&, const Point&) = default;
  friend auto operator<=>(const Point&, const Point&) = default;  ///< by x, then by y
};

struct Line {
  Point a, b;
};

/// +1 when a, b, c turn left, -1 when they turn right, 0 when they lie on one line.
///  (1) swapping two arguments flips the sign;
///  (2) rotating the arguments keeps it;
///  (3) it is 0 when two arguments are equal.
int orientation(const Point& a, const Point& b, const Point& c);

/// The same through big numbers only; `orientation` must agree with it everywhere.
int orientation_by_big_numbers(const Point& a, const Point& b, const Point& c);

/// How two closed straight lines of nonzero length meet.
enum class Meeting {
  kNone,     ///< no common point
  kCross,    ///< one common point, interior to both
  kTouch,    ///< one common point, an end of at least one
  kOverlap,  ///< more than one common point
};
Meeting meeting(const Line& s, const Line& t);

enum class Side { kOutside, kOn, kInside };

/// Where p lies with respect to a closed chain (even-odd; the chain may turn either way).
Side side_of(const Point& p, std::span<const Point> cycle);

/// Twice the signed area: positive for an anticlockwise cycle.
Dyadic twice_area(std::span<const Point> cycle);

}  // namespace limpet::audit
