// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/evaluation/moved_body_internal.hpp>
#include <limpet/evaluation/true_surface.hpp>
#include <limpet/kinematics/posture.hpp>
#include <limpet/survey/random.hpp>
#include <vector>

namespace limpet::evaluation {

/// What a robot must keep to be clear. Lengths in the scan's unit.
struct ArmClearances {
  double control_point = 0;  ///< δ − λ: of the control point from the surface; > 0
  double links = 0;          ///< of all that joints move, from the surface; > 0
  double spared = 0;  ///< of the control point's link what is this near to it keeps `own` instead; ≥ 0
  double own = 0;     ///< of links that are not joined, from each other; > 0
  /// A way on which a clearance is kept by less than half of this is not taken to be clear; > 0.
  double fineness = 0;
  /// How far from the start a prismatic joint without limits is sought; ≥ 0.
  double slide = 0;
};

/// The configurations of a robot that are within the limits of its joints and clear of the true surface and
/// of itself, and the straight ways in joint space that are.
class ArmSpace {
 public:
  /// Keeps references to the robot and to the surface.
  ArmSpace(const kinematics::Robot&, const TrueSurface&, const kinematics::Configuration& start,
           const ArmClearances&);

  const kinematics::Robot& robot() const { return robot_; }
  const TrueSurface& truth() const { return truth_; }
  const ArmClearances& clearances() const { return clearances_; }

  bool holds(const kinematics::Configuration&) const;

  /// Is the whole of the straight way clear, with both its ends? It is proven to be: around each place that
  /// is looked at, nothing moves as far as it has room there. Precondition: both ends are within the limits.
  bool joins(const kinematics::Configuration& from, const kinematics::Configuration& to) const;

  /// `to`, with joints that turn without end turned back by whole turns, so that they are at most half a turn
  /// from `from`.
  kinematics::Configuration near(const kinematics::Configuration& from, kinematics::Configuration to) const;

  /// A bound on how far any point of the robot moves on the straight way to near(from, to).
  double distance(const kinematics::Configuration& from, const kinematics::Configuration& to) const;

  /// Moves what is beyond a joint's limit to it.
  kinematics::Configuration within_limits(const kinematics::Configuration&) const;

  /// Any that is within the limits, clear or not.
  kinematics::Configuration random(survey::Random&) const;

 private:
  /// Something that is to keep a distance: a part from the surface, or from another part.
  struct Guard {
    std::size_t part = 0;
    std::size_t other = kSurface;
    double least = 0;
    Eigen::VectorXd
        levers;  ///< for each joint: how far its unit brings the two nearer to each other, at most
  };
  static constexpr std::size_t kSurface = static_cast<std::size_t>(-1);

  /// How much a guard's distance is above what it has to keep.
  double room(const Guard&, const std::vector<model::Capsule>&) const;
  std::vector<model::Capsule> parts_at(const kinematics::Configuration&) const;

  const kinematics::Robot& robot_;
  const TrueSurface& truth_;
  ArmClearances clearances_;
  MovedBody body_;  ///< its parts come first, then the control point as one without extent, then:
  std::vector<MovedPart> beyond_;  ///< what of the control point's link is not spared
  std::vector<Guard> guards_;
  Eigen::VectorXd levers_;           ///< the largest of each joint
  Eigen::VectorXd low_, high_;       ///< limits of joints
  Eigen::VectorXd from_, to_;        ///< between which joints are sought
  std::vector<char> turns_endless_;  ///< does the joint turn without limits?
};

}  // namespace limpet::evaluation
