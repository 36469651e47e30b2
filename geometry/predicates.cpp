// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/geometry/predicates.hpp>

#include "kernel_internal.hpp"
#include "predicates_internal.hpp"

namespace limpet::geometry {
namespace {

bool in_box(Point2 p, Point2 a, Point2 b) { return box_of(a, b).contains(p); }

}  // namespace

const char* arithmetic() {
#if defined(LIMPET_ARITHMETIC_EXACT)
  return "exact";
#elif defined(LIMPET_ARITHMETIC_FLOAT_GRID)
  return "float-grid";
#else
  return "float";
#endif
}

Point2 round_to_grid(Point2 p) {
#if defined(LIMPET_ARITHMETIC_FLOAT)
  return p;
#else
  // Not rounded_down(x + 0.5): that sum is itself rounded, to 1 for the double just below 1/2, and to an even
  // number for odd ones above 2^52. The difference x - whole is exact wherever it is below 1/2; above, its
  // rounding does not matter.
  const auto nearest = [](double x) {
    const double whole = rounded_down(x);
    return whole + (x - whole >= 0.5);
  };
  return {nearest(p.x), nearest(p.y)};
#endif
}

#if defined(LIMPET_COUNT_STAGES)
/// Printed when the program ends, like the counts of CGAL's own filters.
void internal::count_orientation(bool uncertain) {
  CGAL_BRANCH_PROFILER(" failures/calls to   : limpet::geometry::internal::orientation_filter", counter);
  if (uncertain) CGAL_BRANCH_PROFILER_BRANCH(counter);
}
#endif

int internal::orientation_unfiltered(Point2 p, Point2 q, Point2 r) {
  return CGAL::orientation(to_kernel(p), to_kernel(q), to_kernel(r));
}

int internal::orientation_exact(Point2 p, Point2 q, Point2 r) {
#if defined(LIMPET_ARITHMETIC_EXACT)
  const Kernel::C2E exact;
  return Kernel::Exact_kernel::Orientation_2()(exact(to_kernel(p)), exact(to_kernel(q)), exact(to_kernel(r)));
#else
  return orientation_unfiltered(p, q, r);
#endif
}

bool segments_meet(Point2 a, Point2 b, Point2 c, Point2 d) {
  if (!box_of(a, b).meets(box_of(c, d))) return false;
  const int abc = orientation(a, b, c), abd = orientation(a, b, d);
  if (abc * abd > 0) return false;
  const int cda = orientation(c, d, a), cdb = orientation(c, d, b);
  if (cda * cdb > 0) return false;
  if (abc != 0 || abd != 0 || cda != 0 || cdb != 0) return true;
  return in_box(c, a, b) || in_box(d, a, b) || in_box(a, c, d);  // collinear
}

bool edges_overlap(Point2 apex, Point2 p, Point2 q) {
  if (orientation(apex, p, q) != 0) return false;
  if (p == apex || q == apex) return true;
  // Collinear with the apex: the signs of the differences are exact, so no product is needed.
  const auto same_sign = [](double s, double t) { return (s > 0 && t > 0) || (s < 0 && t < 0); };
  return same_sign(p.x - apex.x, q.x - apex.x) || same_sign(p.y - apex.y, q.y - apex.y);
}

int chain_orientation(std::span<const Point2> chain) {
  std::size_t lowest = 0;
  for (std::size_t i = 1; i < chain.size(); ++i)
    if (chain[i].x < chain[lowest].x || (chain[i].x == chain[lowest].x && chain[i].y < chain[lowest].y))
      lowest = i;
  const std::size_t n = chain.size();
  return orientation(chain[(lowest + n - 1) % n], chain[lowest], chain[(lowest + 1) % n]);
}

}  // namespace limpet::geometry
