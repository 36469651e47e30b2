// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/geometry/polygon.hpp>
#include <limpet/geometry/search.hpp>

namespace limpet::geometry {

enum class Extension {
  contained,  ///< the point lies inside or on a perimeter: there is nothing to do
  shared,  ///< the nearest perimeter point is on a shared edge: the perimeter stays as it is (thesis §2.4.2)
  extended,  ///< the point has become a vertex
  refused,   ///< the point is too far, or no section allows a valid extension
};

/// Extends a section of a perimeter to a point (thesis §2.4.2): two new edges from its ends to q replace it.
/// `q` is a grid point; `gap` is λ in grid steps. The section lies within gap of q, contains the perimeter
/// point nearest to q and no part of a shared edge, and its ends, vertices or points where the perimeter
/// leaves the disc of radius gap, sight q. Of such sections the twelve longest are tried, longest first,
/// until the polygon is valid.
///  (1) `contained` exactly when q is not outside; unless the result is `extended`, the polygon is as it was;
///  (2) when `extended`, the polygon is valid, q is a vertex, and a second call returns `contained`;
///  (3) shared edges stay; area is lost only to rounding, less than a step along the perimeter (the tip of a
///      needle less than a step wide may go);
///  (4) new vertices, and what is added, lie within `gap` of q, up to rounding.
/// Not invariant under motions: ends of the section are rounded, and of two nearest edges either may be
/// taken.
Extension extend_to_point(Polygon&, Point2 q, double gap, EdgeIds&);

/// The same where the perimeter point nearest to q is known, which is nearest_perimeter_point(polygon, q,
/// gap). Precondition: q lies outside.
Extension extend_from(const PerimeterPoint& nearest, Polygon&, Point2 q, double gap, EdgeIds&);

}  // namespace limpet::geometry
