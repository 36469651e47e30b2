// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include "complex_internal.hpp"

namespace limpet::model::internal {

/// May `other` be within λ of `s`, inside it or around it, where s has changed? Never false when a merger
/// could succeed there.
bool may_meet_where_changed(const Setting&, const Segment& s, const DirtyRegion& changed,
                            const Segment& other);
/// Is p within λ of the polygon?
bool lies_near(const Setting&, const PolygonPart&, const Eigen::Vector3d& p);

}  // namespace limpet::model::internal
