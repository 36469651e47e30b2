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
struct PairOfParts {
  std::size_t first = 0, second = 0;
};
bool keeps_apart(const kinematics::Posture&, const kinematics::Configuration& changes,
                 std::span<const kinematics::BodyPart>, std::span<const PairOfParts>, double least);

/// The nearest points of the axes of two capsules, and how far the capsules are from each other.
struct NearestOfCapsules {
  Eigen::Vector3d on_first, on_second;
  /// Unit vector from the second to the first; where the axes meet, any that is at right angles to both.
  Eigen::Vector3d away;
  double distance = 0;  ///< between the surfaces; negative when they overlap
};
NearestOfCapsules nearest_points(const model::Capsule&, const model::Capsule&);
double distance_between(const model::Capsule&, const model::Capsule&);

}  // namespace limpet::following
