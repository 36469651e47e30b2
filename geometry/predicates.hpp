// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cmath>
#include <span>

#include <limpet/geometry/types.hpp>

/// Every decision of geometry/ comes down to these. In the exact build they are exact for all finite doubles
/// (CGAL's exact-predicates kernel). In the float builds they are plain double arithmetic; on grid points
/// below 2^25 steps that is still exact, because every difference fits in 26 bits, every product in 52 and
/// their difference in 53.
namespace limpet::geometry {

/// "exact", "float-grid" or "float": which of the three builds is linked in.
const char* arithmetic();

/// The grid point nearest to p (ties up); p itself in the float build.
Point2 round_to_grid(Point2 p);

/// +1 when p, q, r turn anticlockwise, -1 clockwise, 0 when collinear.
/// Laws: orientation(p,q,r) = orientation(q,r,p) = -orientation(q,p,r); zero when two arguments are equal.
inline int orientation(Point2 p, Point2 q, Point2 r);

/// Do the closed segments ab and cd have a point in common? Symmetric in the segments and in their ends.
bool segments_meet(Point2 a, Point2 b, Point2 c, Point2 d);

/// Do two edges that leave the common point `apex` towards p and q overlap (point the same way)? Also true
/// when p or q is the apex itself.
bool edges_overlap(Point2 apex, Point2 p, Point2 q);

/// +1 when the closed chain is anticlockwise, -1 when clockwise, 0 when it is degenerate at its lowest
/// vertex. Precondition: simple and without repeated points (decided at its extreme vertex).
int chain_orientation(std::span<const Point2> chain);

namespace internal {

/// orientation() where double arithmetic cannot tell the sign.
int orientation_unfiltered(Point2 p, Point2 q, Point2 r);

}  // namespace internal

inline int orientation(Point2 p, Point2 q, Point2 r) {
  // Nearly all cases are told apart here. The error of the difference is below (3 + 16u)u times the sum, with
  // u = 2^-53 (Shewchuk, "Adaptive precision floating-point arithmetic", 1997, A estimate); the last term is
  // for products that underflow. What overflows is left to the other.
  const double left = (q.x - p.x) * (r.y - p.y), right = (q.y - p.y) * (r.x - p.x);
  const double bound = 3.4e-16 * (std::abs(left) + std::abs(right)) + 1e-290;
  if (left - right > bound) return 1;
  if (right - left > bound) return -1;
  return internal::orientation_unfiltered(p, q, r);
}

}  // namespace limpet::geometry
