// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/following/links/link_parameters.hpp>
#include <limpet/following/links/obstacles.hpp>
#include <limpet/following/links/step_check.hpp>
#include <limpet/kinematics/body.hpp>
#include <vector>

namespace limpet::following {

/// What of a robot is kept off what: each part d_s off obstacles, the control point its own distance, parts
/// that are not made to touch off each other, and joints within their limits.
class LinkGuard {
 public:
  /// The robot must outlive it.
  LinkGuard(const kinematics::Robot&, const LinkParameters&);

  const kinematics::Robot& robot() const { return *robot_; }
  const std::vector<kinematics::BodyPart>& body() const { return body_; }
  const std::vector<kinematics::PairOfParts>& pairs() const { return pairs_; }

  /// Does this posture keep all distances and limits?
  bool is_clear(const kinematics::Posture&, const Obstacles&) const;
  /// Are the limits and all distances kept here that are kept there, and is nothing nearer that is too near
  /// there? What lies between is not asked about.
  bool is_no_worse(const kinematics::Posture& here, const kinematics::Posture& there, const Obstacles&) const;
  /// Are all distances kept on the whole way, straight in joint space (keeps_clear(), keeps_apart())? Limits
  /// are not asked about.
  bool keeps(const kinematics::Posture&, const kinematics::Configuration& changes, const Obstacles&) const;
  /// The longest of changes, changes/2, … changes/64 that keeps all distances; zero when none does.
  kinematics::Configuration longest(const kinematics::Posture&, kinematics::Configuration changes,
                                    const Obstacles&) const;
  /// The same as keeps() for a way of any length, from a posture that is clear to another one.
  bool connects(const kinematics::Configuration& from, const kinematics::Configuration& to,
                const Obstacles&) const;

 private:
  const kinematics::Robot* robot_;
  double own_distance_;
  std::vector<kinematics::BodyPart> body_;
  std::vector<GuardedPart> guarded_;  ///< the body, and the control point
  std::vector<kinematics::PairOfParts> pairs_;
};

}  // namespace limpet::following
