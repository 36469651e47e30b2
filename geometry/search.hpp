// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <optional>

#include <limpet/geometry/polygon.hpp>

namespace limpet::geometry {

/// The point of the line segment ab nearest to p, as a fraction of the way from a to b. For ba the result is
/// one minus that only up to rounding.
///  (1) It is 0 at a, 1 at b (0 when a = b), and never outside [0, 1];
///  (2) motions (predicates.hpp) keep it, to the last bit.
inline double nearest_fraction(Point2 a, Point2 b, Point2 p) {
  const double length2 = squared_length(b - a);
  return length2 > 0 ? std::clamp(dot(p - a, b - a) / length2, 0.0, 1.0) : 0.0;
}

/// A perimeter point: on this edge, `fraction` of the way along it.
struct PerimeterPoint {
  Slot edge = kNoSlot;
  double fraction = 0;
  Point2 at;                    ///< not rounded
  double squared_distance = 0;  ///< from the point that was asked about, in grid steps squared
};

/// The perimeter point nearest to p, if nearer than `within` (grid steps); ties go to the edge of lower
/// identity. With `cycle`, on that cycle only.
///  (1) No other perimeter point is nearer, up to rounding;
///  (2) a quarter turn about the origin keeps it, to the last bit. A translation need not: of two edges that
///      are equally near up to rounding, it may find the other one;
///  (3) what is found within a distance is found within any larger one.
std::optional<PerimeterPoint> nearest_perimeter_point(const Polygon&, Point2 p, double within,
                                                      std::optional<CycleId> cycle = {});

/// Has the polygon an edge nearer to the line segment ab than `within` (grid steps)? In double arithmetic: a
/// caller that must not miss any edge adds a grid step.
///  (1) An edge within a distance is within any larger one.
bool any_edge_within(const Polygon&, Point2 a, Point2 b, double within);

/// An end of a line of sight: a point, and the vertex of the polygon that it is, if any.
struct SightEnd {
  Point2 at;
  Slot vertex = kNoSlot;
};

/// Can the two points sight each other: does the straight line between them meet no edge of the perimeters,
/// except at an end that is named as a vertex (thesis §2.4.2)? Edges in `ignored` do not count.
///  (1) Sight is symmetric;
///  (2) what is in sight stays in sight when more edges are ignored;
///  (3) if two points sight each other (the second not named as a vertex), so do each of them and any grid
///      point on the line between them;
///  (4) the ends of an edge do not sight each other; every point sights itself;
///  (5) invariant under motions (predicates.hpp).
bool sights(const Polygon&, SightEnd, SightEnd, std::initializer_list<Slot> ignored = {});

}  // namespace limpet::geometry
