// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/following/links/obstacles.hpp>
#include <limpet/kinematics/body.hpp>
#include <span>
#include <vector>

namespace limpet::following {

/// A part of the robot and the distance that it is to keep.
struct GuardedPart {
  kinematics::BodyPart part;
  double least = 0;  ///< > 0
};

/// Do all parts keep their distances from all obstacles along the whole way that these changes of the
/// actuators take, straight in joint space? What is nearer at the start must come no nearer than that, and be
/// farther at the end. On the way, not at its ends, a hundredth of the distance is forgiven; never more: it
/// is decided by bounds on how far points can move.
bool keeps_clear(const kinematics::Posture&, const kinematics::Configuration& changes, const Obstacles&,
                 std::span<const GuardedPart>);

/// The same for the robot and itself: parts of these pairs (indices of parts) keep `least` from each other.
bool keeps_apart(const kinematics::Posture&, const kinematics::Configuration& changes,
                 std::span<const kinematics::BodyPart>, std::span<const kinematics::PairOfParts>,
                 double least);

}  // namespace limpet::following
