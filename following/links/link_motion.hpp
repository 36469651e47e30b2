// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include <limpet/following/follower.hpp>
#include <limpet/following/links/obstacles.hpp>
#include <limpet/following/links/step_check.hpp>
#include <limpet/kinematics/redundancy.hpp>

namespace limpet::following {

/// How motions of the control point become motions of all joints.
enum class Redundancy {
  thesis,    ///< thesis (3) to (5): the pseudo-inverse, and the gradient of an objective in its null space
  programme  ///< a quadratic programme with a bound on how fast each link nears each obstacle; and a check
};

/// Lengths in the scan's unit.
struct LinkParameters {
  Redundancy redundancy = Redundancy::programme;
  kinematics::RedundancyParameters objective;  ///< of both
  double least_distance = 0.06;  ///< d_s: what a link is to keep from the model and from recent readings; > 0
  double own_distance = 0.01;    ///< what links are to keep from each other; > 0
  double control_clearance = 0.05;  ///< what the control point is to keep (Parameters::clearance())
  double spared = 0.1;  ///< radius of what of the control point's link is left out (thesis §3.3: δ)
};

/// The parameters that go with those of following: √(2 d₀) is the sensing range, d_s 1.2 λ.
LinkParameters usual_link_parameters(const Parameters&, Redundancy);

/// Moves a robot's control point, and keeps its links off what is known of the surface.
///
///     LinkMotion links(robot, parameters);
///     for (...) {
///       const Motion motion = follower->next(seen);
///       robot.move(links.changes(seen, motion.displacement));
///     }
///
///  (1) the changes keep the robot's limits and ceilings;
///  (2) `programme`: along the way in joint space every link keeps d_s (to a hundredth) from the model and
///  from
///      recent readings, where it does at its start; else it comes no nearer, and leads away; or there is no
///      motion;
///  (3) `thesis`: neither is checked, as in the thesis;
///  (4) the same calls give the same changes.
class LinkMotion {
 public:
  /// The robot must outlive it.
  LinkMotion(const kinematics::Robot&, const LinkParameters&);
  ~LinkMotion();

  /// The changes for a motion of the control point, after a set. Precondition: called once for each set, in
  /// order.
  kinematics::Configuration changes(const Observation&, const Eigen::Vector3d& motion);

  /// Smallest distance of a link from the model and recent readings in the posture of the last call, as far
  /// as the objective's influence; infinite beyond.
  double last_clearance() const { return last_clearance_; }

 private:
  kinematics::Configuration by_thesis(const Observation&, const Eigen::Vector3d& motion);
  kinematics::Configuration by_programme(const Observation&, const Eigen::Vector3d& motion);
  kinematics::Configuration longest_clear(const Observation&, kinematics::Configuration changes,
                                          const Obstacles&) const;

  struct Programme;

  const kinematics::Robot& robot_;
  LinkParameters parameters_;
  std::vector<kinematics::BodyPart> body_;
  std::vector<GuardedPart> guarded_;  ///< the body, and the control point
  std::vector<kinematics::PairOfParts> pairs_;
  RecentReadings readings_;
  std::unique_ptr<Programme> programme_;
  double last_clearance_;
};

}  // namespace limpet::following
