// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/geometry/polygon.hpp>

namespace limpet::geometry {

enum class Merger {
  contained,  ///< b lies inside a: a is the result as it stands
  united,     ///< the perimeters overlapped: a is their union
  bridged,    ///< they did not: a section of one was extended to a section of the other
  too_far,    ///< no two perimeter points are nearer than the gap
  refused,    ///< no valid candidate was found
};

/// Merges polygon b into a; both in one chart, `gap` is λ in grid steps (thesis §2.4.3). Holes that the union
/// forms are dropped when they collapse, kept when they do not (a departure from the thesis, which then lets
/// the merger fail).
///  (1) `a` is changed only by `united` and `bridged`, and is valid then;
///  (2) area is lost to rounding only, to moves (unite.hpp) and with needles less than eight steps wide;
///  (3) whether the two are `too_far` does not depend on which is which. Whether a candidate is found may;
///  (4) what is added lies within `gap` of one of them, but for rounding and moves.
Merger merge_polygons(Polygon& a, const Polygon& b, double gap, EdgeIds&);

}  // namespace limpet::geometry
