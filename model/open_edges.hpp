// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstddef>
#include <limpet/model/changes.hpp>

namespace limpet::model {

/// The condition that refuses an open edge a neighbour (thesis §2.6, §2.7), in ascending order of how far the
/// attempt to share it came. Where several attempts were made, the one that came farthest is reported.
enum class Refusal {
  none,              ///< no condition: it would be shared now, unless that broke an ordering (§2.2)
  alone,             ///< no other polygon within λ: the surface ends here, or what was seen of it
  angle,             ///< the planes of all polygons within λ make angles of less than μ/2 with its own
  line_far,          ///< the line where the planes meet is too far away
  nothing_opposite,  ///< the other polygon has no open edge along the line there
  ring_broken,       ///< at a corner: the neighbours around it do not close a ring
  undecided,         ///< neither convex nor concave
  short_section,     ///< the stretch opposite is too short to make two segments neighbours
  goes_on,           ///< one of the segments continues beyond the line
  inside_shared,     ///< a section would have to end inside a shared edge
  other_pairs,       ///< the shared edges along the two sections are not partners of each other
  bay,               ///< a bay deeper than λ, and too large to be a chance gap between the readings
  one_sided_end,     ///< the new edge would end at a shared edge of only one of the two
  corner_far,        ///< at a corner: the planes meet farther than λ from the perimeter
  corner_bay,        ///< at a corner: a bay as above
  corner_turns,      ///< at a corner: a shared edge would reverse its direction, or vanish
  perimeter,         ///< a perimeter would no longer be a valid polygon
};

inline constexpr std::size_t kRefusals = 17;

/// The condition for people to read, in a few words; and its name for programs, with underscores.
const char* words(Refusal);
const char* name(Refusal);

/// An open edge, and the condition that refuses it a neighbour.
struct OpenEdge {
  SegmentId segment;
  geometry::EdgeId edge;
  Refusal refusal = Refusal::none;
  SegmentId other;  ///< the segment it was not shared with; none if `alone`
};

}  // namespace limpet::model
