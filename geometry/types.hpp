// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>
#include <limits>

namespace limpet::geometry {

/// A point of a chart, in grid steps. In the exact and float-grid builds both coordinates are whole numbers.
struct Point2 {
  double x = 0, y = 0;
  friend bool operator==(const Point2&, const Point2&) = default;
};
inline Point2 operator+(Point2 a, Point2 b) { return {a.x + b.x, a.y + b.y}; }
inline Point2 operator-(Point2 a, Point2 b) { return {a.x - b.x, a.y - b.y}; }
inline Point2 operator*(double s, Point2 a) { return {s * a.x, s * a.y}; }
inline double dot(Point2 a, Point2 b) { return a.x * b.x + a.y * b.y; }
inline double cross(Point2 a, Point2 b) { return a.x * b.y - a.y * b.x; }
inline double squared_length(Point2 a) { return dot(a, a); }

/// The largest whole number not above x; x itself when it is infinite or NaN. Inline, because std::floor is a
/// library call unless the compiler may use SSE4.1.
inline double rounded_down(double x) {
  if (!(x > -0x1p52 && x < 0x1p52)) return x;  // whole already, or NaN
  const auto whole = static_cast<double>(static_cast<std::int64_t>(x));
  return whole - (whole > x);
}

/// Axis-aligned bounding box of chart points; empty until something is added.
///  (1) box_of(a, b) = box_of(b, a), and it contains a and b;
///  (2) meets() is symmetric, and true when one box contains a point of the other;
///  (3) squared_distance() is 0 for a point the box contains; an empty box meets and contains nothing.
struct Box2 {
  Point2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void add(Point2 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  void add(const Box2& b) { add(b.low), add(b.high); }
  Box2 grown(double by) const { return {{low.x - by, low.y - by}, {high.x + by, high.y + by}}; }
  bool contains(Point2 p) const { return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y; }
  /// From p to the box; 0 inside.
  double squared_distance(Point2 p) const {
    const double dx = std::max({0.0, low.x - p.x, p.x - high.x}),
                 dy = std::max({0.0, low.y - p.y, p.y - high.y});
    return dx * dx + dy * dy;
  }
  bool meets(const Box2& b) const {
    return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y;
  }
};
inline Box2 box_of(Point2 a, Point2 b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

/// Identity of an edge. The edge keeps it through every operation that leaves the edge as it is; no other
/// edge ever gets it.
struct EdgeId {
  std::uint64_t value = 0;  ///< 0: no edge
  explicit operator bool() const { return value != 0; }
  friend auto operator<=>(const EdgeId&, const EdgeId&) = default;
};

/// Hands out edge identities in ascending order.
class EdgeIds {
 public:
  explicit EdgeIds(std::uint64_t first = 1) : next_(first) {}
  EdgeId take() { return {next_++}; }
  std::uint64_t next() const { return next_; }

 private:
  std::uint64_t next_;
};

/// Index of a vertex in its polygon's storage; it also names the edge that leaves the vertex. Valid until the
/// vertex is removed.
enum class Slot : std::uint32_t {};
inline constexpr Slot kNoSlot{0xffffffffu};

/// Index of a boundary cycle of a polygon. Valid until the polygon is edited.
enum class CycleId : std::uint32_t {};

}  // namespace limpet::geometry
