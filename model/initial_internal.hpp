// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/model/model.hpp>
#include <span>
#include <stdexcept>

#include "complex_internal.hpp"

namespace limpet::model::internal {

/// A face is refused; nothing of it has been added.
class Refused : public std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// Adds initial model segments (thesis §4.3), face by face. Where exactly two of them have an edge in common,
/// from one vertex to the same other one and back, they share it, at less than μ, too: no points tell whether
/// there is an angle. Not shared are edges of faces in almost one plane (kLeastSine), those of which an end
/// is not in the plane of the other face to the rounding, and what would break an ordering.
///
/// Throws Refused, which names the face by its number, when one has fewer than three vertices,
/// no area, a vertex that is not finite or beyond 2^48 grid steps, is wider than 2^40, or is no simple
/// polygon; then those before it have been added, and share nothing.
void add_initial(Complex&, std::span<const InitialFace>);

}  // namespace limpet::model::internal
