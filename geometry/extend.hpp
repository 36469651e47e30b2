// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/geometry/polygon.hpp>

namespace limpet::geometry {

enum class Extension {
  contained,  ///< the point lies inside or on a perimeter: nothing to do
  shared,     ///< the nearest perimeter point lies on a shared edge: the perimeter stays as it is (thesis
              ///< §2.4.2)
  extended,   ///< the point is a vertex now
  refused,    ///< too far, or no valid pair of perimeter points
};

/// Extends a perimeter section to a point (thesis §2.4.2). `q` is a grid point; `gap` is λ in grid steps. The
/// section lies entirely within gap of q, holds the perimeter point nearest to q and no part of a shared
/// edge, its ends sight q, and it is the longest such section; its ends are vertices or points where the
/// perimeter leaves the disc of radius gap.
///  (1) `contained` exactly when q is not outside; unless the result is `extended`, the polygon is as it was;
///  (2) when `extended`, it is valid, q is a vertex, and asking again is answered `contained`;
///  (3) shared edges stay; area is lost to rounding only, less than a step along the perimeter (the tip of a
///      needle less than a step wide may go);
///  (4) new vertices, and what is added, lie within `gap` of q, but for rounding.
/// Motions need not keep it: ends of the section are rounded, and the nearest edge may be one of two.
Extension extend_to_point(Polygon&, Point2 q, double gap, EdgeIds&);

}  // namespace limpet::geometry
