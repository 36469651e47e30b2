// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/geometry/gap.hpp>
#include <limpet/geometry/polygon.hpp>

namespace limpet::geometry {

enum class Merger {
  contained,  ///< b lies inside a: a is the result as it stands
  united,     ///< the polygons overlapped: a is their union
  bridged,    ///< they did not: a section of one perimeter was extended to a section of the other
  too_far,    ///< all perimeter points of one are at least the gap away from those of the other
  refused,    ///< no valid candidate was found
};

/// Merges polygon b into a; both are in one chart, `gap` is λ in grid steps (thesis §2.4.3). Holes that the
/// union forms are dropped when they collapse (fissure.hpp), and kept otherwise, where the thesis would give
/// up the merger.
///  (1) `a` changes only with the results `united` and `bridged`, and is then valid;
///  (2) the only area lost is lost to rounding, to the moves of unite(), and with needles less than eight
///      steps wide;
///  (3) whether the result is `too_far` does not depend on which polygon is a; whether a candidate is found
///      may;
///  (4) what is added lies within `gap` of one of the two, up to rounding and moves.
Merger merge_polygons(Polygon& a, const Polygon& b, const Gap& gap, EdgeIds&);

}  // namespace limpet::geometry
