// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstddef>
#include <limpet/model/changes.hpp>

namespace limpet::model {

/// What stands between an open edge and a neighbour (thesis §2.6, §2.7), in the order in which it is asked:
/// where several sections were tried, the one that came farthest tells.
enum class Refusal {
  none,              ///< nothing: what would be shared now, if an order did not dissolve it (§2.2)
  alone,             ///< no other polygon within λ: where the surface, or what was seen of it, ends
  angle,             ///< only polygons within λ whose planes are at less than μ to its own
  line_far,          ///< the line where the planes meet passes too far
  nothing_opposite,  ///< the other polygon has no open edge along the line there
  ring_broken,       ///< at a corner: the neighbours around it do not close a ring
  undecided,         ///< neither convex nor concave
  short_section,     ///< what lies opposite is too short to make two segments neighbours
  goes_on,           ///< one segment goes on beyond the line
  inside_shared,     ///< a section would have to end inside a shared edge
  other_pairs,       ///< the shared edges along the two sections are not each other's
  bay,               ///< a bay deeper than λ that chance alone does not explain
  one_sided_end,     ///< the new edge would end at a shared edge of only one of the two
  corner_far,        ///< at a corner: the planes meet farther than λ from the perimeter
  corner_bay,        ///< at a corner: as `bay`
  corner_turns,      ///< at a corner: a shared edge would have to turn round, or to vanish
  perimeter,         ///< a perimeter would not be valid
};

inline constexpr std::size_t kRefusals = 17;

/// A few words for people; one word, with underscores, for programs.
const char* words(Refusal);
const char* name(Refusal);

/// An edge without neighbour, and what refused it one.
struct OpenEdge {
  SegmentId segment;
  geometry::EdgeId edge;
  Refusal refusal = Refusal::none;
  SegmentId other;  ///< the segment it was not shared with; none where it is alone
};

}  // namespace limpet::model
