// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <functional>
#include <limpet/geometry/gap.hpp>
#include <limpet/geometry/polygon.hpp>
#include <span>
#include <utility>

namespace limpet::geometry {

/// May the region between a narrow inlet's sides, clockwise, be added?
using MayFill = std::function<bool(std::span<const Point2> region)>;

/// Fills fissures, narrow inlets of a perimeter (thesis §2.5), that the edges in `fresh` take part in; new
/// edges that come of it are examined in turn. For consecutive vertices the types are tried in the order IV,
/// V, VI, I, II, III. Where none is found and `bridge` is true, sections of one perimeter that are within
/// `gap` and in sight of each other are bridged (thesis §2.3, "between two points on the same model
/// segment"), since a perimeter that grows around something comes to meet itself. A hole that collapses is
/// dropped. `gap` is asked beside each inlet. Returns the number of changes.
///  (1) The polygon stays valid; when nothing was filled, it is as it was;
///  (2) shared edges stay;
///  (3) area is lost only to the rounding of new vertices, at most two steps along the perimeter (the tip of
///      a needle less than a step wide may go);
///  (4) what is added lies within `gap` of what was there, up to rounding.
/// A second call may fill more, where the first has opened a line of sight. `may_fill`, where there is one,
/// is asked of the region that a filling would add, clockwise; what it refuses stays open.
std::size_t fill_fissures(Polygon&, std::span<const std::pair<Slot, EdgeId>> fresh, const Gap& gap, EdgeIds&,
                          bool bridge = true, const MayFill& may_fill = {});

/// Does a closed chain collapse, that is, shrink to fewer than three vertices when its fissures are filled
/// without regard to shared edges and sight (thesis §2.4.3, §2.5)? Greedy: for a chain that only just
/// collapses the answer may depend on its first vertex, may change with a quarter turn (because of rounding),
/// and may even be false at a wider gap.
bool collapses(std::vector<Point2> chain, double gap);

}  // namespace limpet::geometry
