// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/following/follower.hpp>
#include <memory>

namespace limpet::following {

/// The surface following algorithm of thesis chapter 3 (§3.2, §3.4), with the holes of its rules closed: a
/// robot that goes round in a circle makes no progress; a face is not given up for one edge in the way; a
/// path hops to perimeters that shared edges do not lead to; a point segment that becomes no polygon does not
/// end the run; what is unreachable is tried once more when the control point comes closest to it, not each
/// time; an edge that finishing the model would close is complete; and no place is visited without end.
/// Throws std::invalid_argument when the parameters are not sound.
std::unique_ptr<Follower> make_thesis_follower(const Parameters&,
                                               std::unique_ptr<LinkMotion> links = nullptr);

}  // namespace limpet::following
