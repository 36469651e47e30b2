// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include "agenda_internal.hpp"
#include "complex_internal.hpp"

/// Faces of one plane that touch in a vertex (rule `pinches`, docs/neighbours.md).
namespace limpet::model::internal {

/// Cuts polygons in two that fill two opposite ones of the four quadrants into which two other polygons'
/// planes divide theirs, near these, and not the other two. Their data is divided by area. Returns whether
/// there were any. Until finish() ends, the parts do not merge again.
bool cut_at_pinches(Complex&, Agenda&);

/// Do both lie at one of the places where a polygon was cut?
bool parted(const Setting&, const Agenda&, const Segment&, const Segment&);

}  // namespace limpet::model::internal
