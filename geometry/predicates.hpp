// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cmath>
#include <span>

#include <limpet/geometry/types.hpp>

/// Every decision of geometry/ comes down to these. In the exact build they are exact for all finite doubles
/// (CGAL's exact-predicates kernel). In the float builds they are plain double arithmetic; on grid points
/// below 2^25 steps that is still exact, because every difference fits in 26 bits, every product in 52 and
/// their difference in 53.
///
/// The numbered laws hold for all finite doubles in the exact build. A *motion* here is a translation by
/// whole steps, a quarter turn, or both, of grid points that stay below 2^53 steps, where all sums are exact.
namespace limpet::geometry {

/// "exact", "float-grid" or "float": which of the three builds is linked in.
const char* arithmetic();

/// The grid point nearest to p (ties up); p itself in the float build.
///  (1) No coordinate moves by more than half a step, and exactly half a step only upwards;
///  (2) grid points stay where they are;
///  (3) it commutes with translations by whole steps where these are exact. Not with turns: ties
///      go up.
Point2 round_to_grid(Point2 p);

/// +1 when p, q, r turn anticlockwise, -1 clockwise, 0 when collinear.
///  (1) Rotating the arguments keeps it;
///  (2) swapping two of them flips it;
///  (3) it is 0 when two of them are equal;
///  (4) motions keep it, the mirror (x, y) -> (-x, y) flips it;
///  (5) when (t,q,r), (p,t,r) and (p,q,t) turn anticlockwise, so do p, q, r;
///  (6) where p, q, r are left of st: if neither (s,p,q) nor (s,q,r) turns clockwise, then (s,p,r)
///      does not, and is collinear only when both are;
///  (7) where p and q differ: if r and s are collinear with p, q, then p, r, s and q, r, s are
///      collinear.
inline int orientation(Point2 p, Point2 q, Point2 r);

/// Do the closed segments ab and cd have a point in common?
///  (1) Symmetric in the segments and in their ends;
///  (2) a segment meets itself and what shares an end with it; two points meet when they are one;
///  (3) for m on cd: ab meets cd when it meets cm or md, and only then;
///  (4) motions and the mirror keep it.
bool segments_meet(Point2 a, Point2 b, Point2 c, Point2 d);

/// Do two edges that leave the common point `apex` towards p and q overlap (point the same way)? Also true
/// when p or q is the apex itself.
///  (1) Symmetric in p and q;
///  (2) true when p or q is the apex, or both are one;
///  (3) transitive: where q is not the apex, if p overlaps q and q overlaps r, then p overlaps r;
///  (4) of an edge and its opposite, a collinear third one overlaps exactly one;
///  (5) motions and the mirror keep it.
bool edges_overlap(Point2 apex, Point2 p, Point2 q);

/// +1 when the closed chain is anticlockwise, -1 when clockwise, 0 when it is degenerate at its lowest
/// vertex. Precondition: simple and without repeated points (decided at its extreme vertex).
///  (1) No start of the chain is special;
///  (2) reversal flips it;
///  (3) it is the sign of the area;
///  (4) motions keep it.
int chain_orientation(std::span<const Point2> chain);

namespace internal {

/// The first stage of orientation(), in doubles: its sign where that is certain, 0 where it is not (also when
/// it is zero).
///  (1) Where it answers, so does the exact stage.
inline int orientation_filter(Point2 p, Point2 q, Point2 r) {
  // The error of the difference is below (3 + 16u)u times the sum, with u = 2^-53 (Shewchuk, "Adaptive
  // precision floating-point arithmetic", 1997, A estimate); the last term is for products that underflow.
  // Where something overflows, the bound is infinite or no number, and nothing is certain.
  const double left = (q.x - p.x) * (r.y - p.y), right = (q.y - p.y) * (r.x - p.x);
  const double bound = 3.4e-16 * (std::abs(left) + std::abs(right)) + 1e-290;
  return left - right > bound ? 1 : right - left > bound ? -1 : 0;
}

/// The second stage, for what the first leaves open: the build's kernel.
int orientation_unfiltered(Point2 p, Point2 q, Point2 r);

#if defined(LIMPET_COUNT_STAGES)  // geometry/ alone, in a build for benchmarks
void count_orientation(bool uncertain);
#endif

}  // namespace internal

inline int orientation(Point2 p, Point2 q, Point2 r) {
  const int sign = internal::orientation_filter(p, q, r);
#if defined(LIMPET_COUNT_STAGES)
  internal::count_orientation(sign == 0);
#endif
  if (sign != 0) return sign;  // nearly always
  return internal::orientation_unfiltered(p, q, r);
}

}  // namespace limpet::geometry
