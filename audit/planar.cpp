// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <cmath>
#include <limpet/audit/planar_internal.hpp>

namespace limpet::audit {
namespace {

// Differences of whole numbers this small are at most 2^46 and their products at most 2^92, so 128 bits hold
// a sum of 2^33 cross products.
constexpr double kWholeLimit = 0x1p45;

bool is_small_whole(double x) { return std::abs(x) <= kWholeLimit && x == std::trunc(x); }
bool is_small_whole(const Point& p) { return is_small_whole(p.x) && is_small_whole(p.y); }

Int128 whole_cross(const Point& a, const Point& b, const Point& c) {
  const Int128 ux = static_cast<std::int64_t>(b.x) - static_cast<std::int64_t>(a.x);
  const Int128 uy = static_cast<std::int64_t>(b.y) - static_cast<std::int64_t>(a.y);
  const Int128 vx = static_cast<std::int64_t>(c.x) - static_cast<std::int64_t>(a.x);
  const Int128 vy = static_cast<std::int64_t>(c.y) - static_cast<std::int64_t>(a.y);
  return ux * vy - uy * vx;
}

Dyadic big_cross(const Point& a, const Point& b, const Point& c) {
  return (Dyadic(b.x) - Dyadic(a.x)) * (Dyadic(c.y) - Dyadic(a.y)) -
         (Dyadic(b.y) - Dyadic(a.y)) * (Dyadic(c.x) - Dyadic(a.x));
}

// Is p on s? Precondition: p is on the infinite line through s.
bool is_within(const Point& p, const Line& s) { return std::min(s.a, s.b) <= p && p <= std::max(s.a, s.b); }

// For collinear segments the lexicographic order of points is their order along the common line.
Meeting collinear_meeting(const Line& s, const Line& t) {
  const Point begin = std::max(std::min(s.a, s.b), std::min(t.a, t.b));
  const Point end = std::min(std::max(s.a, s.b), std::max(t.a, t.b));
  if (end < begin) return Meeting::kNone;
  return begin == end ? Meeting::kTouch : Meeting::kOverlap;
}

}  // namespace

int orientation_by_big_numbers(const Point& a, const Point& b, const Point& c) {
  return big_cross(a, b, c).sign();
}

int orientation(const Point& a, const Point& b, const Point& c) {
  if (is_small_whole(a) && is_small_whole(b) && is_small_whole(c)) {
    const Int128 value = whole_cross(a, b, c);
    return (value > 0) - (value < 0);
  }
  return orientation_by_big_numbers(a, b, c);
}

Meeting meeting(const Line& s, const Line& t) {
  const int ta = orientation(s.a, s.b, t.a);
  const int tb = orientation(s.a, s.b, t.b);
  if (ta == 0 && tb == 0) return collinear_meeting(s, t);
  const int sa = orientation(t.a, t.b, s.a);
  const int sb = orientation(t.a, t.b, s.b);
  if (ta * tb > 0 || sa * sb > 0) return Meeting::kNone;
  if (ta * tb < 0 && sa * sb < 0) return Meeting::kCross;
  const bool touches = (ta == 0 && is_within(t.a, s)) || (tb == 0 && is_within(t.b, s)) ||
                       (sa == 0 && is_within(s.a, t)) || (sb == 0 && is_within(s.b, t));
  return touches ? Meeting::kTouch : Meeting::kNone;
}

Side side_of(const Point& p, std::span<const Point> cycle) {
  bool inside = false;
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const Point& a = cycle[i];
    const Point& b = cycle[i + 1 == cycle.size() ? 0 : i + 1];
    if (a.y == p.y && b.y == p.y && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x)) return Side::kOn;
    if (a == p) return Side::kOn;
    // Edges are half-open in y, so that a ray through a vertex counts one of the two edges there.
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    const int turn = orientation(a, b, p);
    if (turn == 0) return Side::kOn;
    if ((turn > 0) == (a.y < b.y)) inside = !inside;
  }
  return inside ? Side::kInside : Side::kOutside;
}

Dyadic twice_area(std::span<const Point> cycle) {
  if (cycle.size() < 3) return 0;
  const bool whole =
      std::all_of(cycle.begin(), cycle.end(), [](const Point& p) { return is_small_whole(p); });
  Int128 whole_sum = 0;
  Dyadic big_sum;
  for (std::size_t i = 1; i + 1 < cycle.size(); ++i) {
    if (whole)
      whole_sum += whole_cross(cycle[0], cycle[i], cycle[i + 1]);
    else
      big_sum = big_sum + big_cross(cycle[0], cycle[i], cycle[i + 1]);
  }
  return whole ? Dyadic(whole_sum) : big_sum;
}

int area_sign(std::span<const Point> cycle) { return twice_area(cycle).sign(); }

}  // namespace limpet::audit
