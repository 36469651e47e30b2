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

}  // namespace limpet::kinematics
