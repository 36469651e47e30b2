// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/model/open_edges.hpp>
#include <vector>

#include "common_line_internal.hpp"
#include "complex_internal.hpp"

namespace limpet::model::internal {

/// What one segment of a ring gives up for its corner vertex: the stretch P between two shared edges that
/// follow each other (thesis §2.7).
struct RingPart {
  const Segment* segment = nullptr;
  geometry::Slot before = geometry::kNoSlot, after = geometry::kNoSlot;  ///< e₁ and e₂
  std::vector<geometry::Slot> between;                                   ///< the vertices of P, v₁ to v₂
  CommonLine line_before, line_after;
  geometry::Point2 corner;
};

struct Ring {
  std::vector<RingPart> parts;
  bool closed = false;
};

/// The ring of §2.7, starting with e₁ of s: f₁ is e₂'s copy on the next segment, and so on back to e₁. Not
/// closed if it does not come back over distinct segments; then the parts are those it came through.
Ring ring_from(const Complex&, const Segment& s, geometry::Slot first);

/// The changes of all perimeters that form the corner, one for each part of the ring, all of them judged; or
/// what refuses it.
struct CornerEdits {
  Refusal refusal = Refusal::none;
  bool formed_already = false;
  std::vector<geometry::Edit> edits;
};
CornerEdits edits_for(const Complex&, Ring&, const SharingReach&);

}  // namespace limpet::model::internal
