// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/model/open_edges.hpp>
#include <vector>

#include "common_line_internal.hpp"
#include "complex_internal.hpp"

namespace limpet::model::internal {

/// The stretch P of one segment's perimeter that its corner vertex replaces: it lies between two successive
/// shared edges (thesis §2.7).
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

/// The ring of §2.7, starting with e₁ of s: f₁ is e₂'s copy on the next segment, and so on back to e₁. It is
/// not closed if it does not return to e₁ over distinct segments; then `parts` are those passed until there.
Ring ring_from(const Complex&, const Segment& s, geometry::Slot first);

/// The plane of the segment that has the edge's partner. Precondition: it has one.
inline geometry::Plane plane_across(const Complex& complex, geometry::EdgeId edge) {
  return complex.at(complex.edges().across(edge).segment).polygon->plane();
}

/// Where the corner is on a part of a ring: where the lines of e₁ and e₂ meet. Where these run on in one line
/// or nearly so (kRunsOnSine), it is the place on the part's plane that is nearest to all planes of the ring;
/// nothing if that is farther than kRunsOnReach from one of the two neighbours' planes.
std::optional<Eigen::Vector3d> place_of_corner(const Complex&, const Ring&, const RingPart&);
/// The same for a vertex of `s`, which is a corner already: `line` is that of one of its edges, and `other`
/// is the other one. What the planes do not determine stays as near as may be to `near`.
std::optional<Eigen::Vector3d> place_of_corner(const Complex&, const Segment& s, geometry::Slot vertex,
                                               const CommonLine& line, geometry::EdgeId other,
                                               const Eigen::Vector3d& near);

/// The edits that form the corner, one for each part of the ring, all judged valid; or the condition that
/// refuses it.
struct CornerEdits {
  Refusal refusal = Refusal::none;
  bool formed_already = false;
  std::vector<geometry::Edit> edits;
};
CornerEdits edits_for(const Complex&, Ring&, const SharingReach&);

}  // namespace limpet::model::internal
