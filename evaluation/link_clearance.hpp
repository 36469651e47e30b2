// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstddef>
#include <limits>
#include <limpet/evaluation/true_surface.hpp>
#include <limpet/kinematics/posture.hpp>
#include <span>

namespace limpet::evaluation {

/// How near a robot's links came to the true surface, and to each other. Lengths are in the scan's unit.
struct LinkClearance {
  double to_surface =
      std::numeric_limits<double>::infinity();                 ///< smallest; negative: a link reached into it
  double to_itself = std::numeric_limits<double>::infinity();  ///< smallest between links that are not joined
  std::size_t worst = 0;  ///< the step, from configuration `worst` to the next, with the smallest to_surface
  std::size_t worst_link = 0;       ///< and the link
  std::size_t collisions = 0;       ///< steps on which a link touched the surface
  std::size_t self_collisions = 0;  ///< steps on which links touched each other
};

/// Measures all links that a joint moves along a way that is straight in joint space from each configuration
/// to the next. Looks at places on the way between which no part moves more than `fineness`: to_surface and
/// to_itself are too large by half of that at most. Links that touch in the first configuration, or with all
/// joints at rest (at 0, or the limit nearest to it), are taken to be made so.
LinkClearance link_clearance(const kinematics::Robot&, std::span<const kinematics::Configuration> way,
                             const TrueSurface& truth, double fineness);

}  // namespace limpet::evaluation
