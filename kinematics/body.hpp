// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstddef>
#include <limpet/kinematics/posture.hpp>
#include <limpet/model/view.hpp>
#include <vector>

namespace limpet::kinematics {

/// A capsule of a link's body, in the link's frame.
struct BodyPart {
  std::size_t link = 0;
  model::Capsule capsule;
};

/// The parts of a robot's body that are to be kept off a surface: those of links that a joint moves, and of
/// the control point's link only what is farther than `spared` (scan's unit, ≥ 0) from the control point,
/// which has a clearance of its own (thesis §3.3). A capsule's axis is cut where it enters that ball; where
/// it passes through, both ends are kept. In the order of links.
std::vector<BodyPart> moving_body(const Robot&, double spared);

/// The part in the world.
model::Capsule in_world(const BodyPart&, const Posture&);

/// Does a joint move the link, its own or one it is carried by?
bool is_moved(const Robot&, std::size_t link);

/// For each joint that moves, an upper bound on how far a unit of its motion (a radian, a length) moves any
/// point of the capsule: 1 for a prismatic joint, for a revolute one the largest distance of the capsule from
/// its axis in this posture; 0 for a joint that does not carry the part.
Eigen::VectorXd reach_of_joints(const BodyPart&, const Posture&);

/// How far the control point moves at most for a unit of one joint: the longest column of its Jacobian; 1
/// where nothing moves it.
double largest_lever(const Posture&);

/// Two parts of a robot that are to be kept apart, as indices of its parts.
struct PairOfParts {
  std::size_t first = 0, second = 0;
};

/// The pairs of parts that must not touch each other: those that do not by the robot's make. It is made so
/// that parts of one rigid body touch (of one link, or of links with fixed joints between them), those of
/// bodies that are joined, also through links without extent, and those that overlap when all joints are at
/// rest: at 0, or at the limit that is nearest to it.
std::vector<PairOfParts> pairs_to_keep_apart(const Robot&, const std::vector<BodyPart>&);

/// The nearest points of the axes of two capsules, and how far the capsules are from each other.
struct NearestOfCapsules {
  Eigen::Vector3d on_first, on_second;
  /// Unit vector from the second to the first; where the axes meet, any that is at right angles to both.
  Eigen::Vector3d away;
  double distance = 0;  ///< between the surfaces; negative when they overlap
};
NearestOfCapsules nearest_points(const model::Capsule&, const model::Capsule&);
double distance_between(const model::Capsule&, const model::Capsule&);

}  // namespace limpet::kinematics
