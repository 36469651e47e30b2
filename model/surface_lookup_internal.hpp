// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include "engine_internal.hpp"

/// Surfaces, asked for by one of their segments (thesis §2.2).
namespace limpet::model::internal {

/// The lowest identity in the surface of a segment; none when there is no such segment.
SegmentId surface_of(const Engine&, SegmentId);
/// All segments of its surface, ascending; `found` is cleared first.
void surface_members(const Engine&, SegmentId, std::vector<SegmentId>& found);

}  // namespace limpet::model::internal
