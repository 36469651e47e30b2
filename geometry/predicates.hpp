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
/// The numbered laws hold for all finite doubles in the exact build. A *motion* is a translation by whole
/// steps, a quarter turn, or both, of grid points that stay below 2^53 steps, so that the motion itself is
/// exact; the *reflection* is (x, y) -> (-x, y).
namespace limpet::geometry {

/// "exact", "float-grid" or "float": which of the three builds is linked in.
const char* arithmetic();

/// The grid point nearest to p, ties rounded towards +infinity; p itself in the float build.
///  (1) No coordinate moves by more than half a step, and exactly half a step only upwards;
///  (2) grid points stay where they are;
///  (3) it commutes with translations by whole steps where these are exact, but not with quarter turns,
///      because of ties.
Point2 round_to_grid(Point2 p);

/// +1 when p, q, r turn anticlockwise, -1 clockwise, 0 when collinear.
///  (1) Rotating the arguments keeps it;
///  (2) swapping two of them flips it;
///  (3) it is 0 when two of them are equal;
///  (4) motions keep it, the reflection flips it;
///  (5) when (t,q,r), (p,t,r) and (p,q,t) turn anticlockwise, so do p, q, r;
///  (6) for p, q, r on the left of st: if neither (s,p,q) nor (s,q,r) turns clockwise, then neither does
///      (s,p,r), and it is collinear only when both are;
///  (7) for p and q that differ: if r and s are both collinear with p and q, then so are p, r, s and q, r, s.
inline int orientation(Point2 p, Point2 q, Point2 r);

/// Do the closed line segments ab and cd have a point in common? Either may be a single point.
///  (1) Symmetric in the segments and in their ends;
///  (2) a segment meets itself and any segment it shares an end with; two points meet when they are equal;
///  (3) for m on cd: ab meets cd exactly when it meets cm or md;
///  (4) invariant under motions and reflection.
bool segments_meet(Point2 a, Point2 b, Point2 c, Point2 d);

/// Do the edges from the common point `apex` to p and to q have the same direction, so that they overlap?
/// Also true when p or q is the apex itself.
///  (1) Symmetric in p and q;
///  (2) true when p or q is the apex, or p = q;
///  (3) transitive, for q other than the apex: if p overlaps q and q overlaps r, then p overlaps r;
///  (4) an edge collinear with another overlaps exactly one of that edge and its opposite;
///  (5) invariant under motions and reflection.
bool edges_overlap(Point2 apex, Point2 p, Point2 q);

/// +1 when the closed chain is anticlockwise, -1 when it is clockwise. Decided by the turn at its
/// lexicographically smallest vertex; 0 when the chain does not turn there. Precondition: simple, no point
/// twice.
///  (1) It does not depend on where the chain starts;
///  (2) reversing the chain flips it;
///  (3) it is the sign of the signed area;
///  (4) motions keep it.
int chain_orientation(std::span<const Point2> chain);

namespace internal {

/// The first stage of orientation(), a floating-point filter: the sign where it is certain, 0 where it is
/// not, which includes all collinear points.
///  (1) Where it is not 0, it is what the exact stage answers.
inline int orientation_filter(Point2 p, Point2 q, Point2 r) {
  // The rounding error of left - right is below (3 + 16u)u (|left| + |right|) with u = 2^-53 (Shewchuk,
  // "Adaptive precision floating-point arithmetic", 1997, A estimate); the last term covers products that
  // underflow. Where something overflows, the bound is infinite or NaN, and both comparisons fail.
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
