// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <compare>
#include <span>

/// Planar predicates, exact for all finite doubles.
namespace limpet::audit {

/// Ordered by x, then by y.
struct Point {
  double x = 0, y = 0;
  friend bool operator==(const Point&, const Point&) = default;
  friend auto operator<=>(const Point&, const Point&) = default;
};

/// A closed line segment. (A "segment" alone is a segment of the model.)
struct Line {
  Point a, b;
};

/// +1 when a, b, c turn left, -1 when they turn right, 0 when they are collinear.
///  (1) Swapping two arguments flips the sign;
///  (2) rotating the arguments keeps it;
///  (3) it is 0 when two arguments are equal.
int orientation(const Point& a, const Point& b, const Point& c);

/// The same in arbitrary-precision arithmetic throughout. orientation() takes a faster path where coordinates
/// are small whole numbers, and must agree with this everywhere.
int orientation_by_big_numbers(const Point& a, const Point& b, const Point& c);

/// How two line segments of nonzero length meet.
enum class Meeting {
  kNone,     ///< no common point
  kCross,    ///< one common point, interior to both
  kTouch,    ///< one common point, an end of at least one
  kOverlap,  ///< more than one common point
};
Meeting meeting(const Line& s, const Line& t);

enum class Side { kOutside, kOn, kInside };

/// Where p lies with respect to a closed chain, by the even-odd rule. The chain's orientation does not
/// matter.
Side side_of(const Point& p, std::span<const Point> cycle);

/// The sign of the signed area of a closed chain: +1 when it is anticlockwise, -1 when it is clockwise.
int area_sign(std::span<const Point> cycle);

}  // namespace limpet::audit
