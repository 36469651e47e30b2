// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/following/links/joint_watch.hpp>
#include <limpet/following/links/link_guard.hpp>
#include <limpet/following/links/link_parameters.hpp>
#include <limpet/following/links/sensed_space.hpp>
#include <limpet/following/links/step_programme.hpp>
#include <limpet/following/links/unmodelled_readings.hpp>
#include <limpet/following/observation.hpp>
#include <optional>
#include <vector>

namespace limpet::following {

/// Moves a robot's control point, and keeps its links off what is known of the surface: of the model and of
/// readings where it is, of proximity switches that it is there (thesis §3.3).
///
///     LinkMotion links(robot, parameters);
///     for (...) {
///       links.look(seen);
///       robot.move(links.changes(motion));
///     }
///
///  (1) the changes keep the robot's limits and ceilings;
///  (2) `programme`: along the way in joint space every link keeps d_s (to a hundredth) from the model and
///      from what readings tell that it does not have yet, where it does at its start; else it comes no
///      nearer, and leads away; or there is no motion;
///  (3) `thesis`: neither is checked, as in the thesis;
///  (4) a joint that is found to be stuck is held where it is;
///  (5) `programme`: along changes() a switch that sees something of which the model has nothing comes no
///      nearer to the centre of its field, to first order, unless nothing else leads links away from what is
///      too near (where the model has something it is known better); `thesis`: links that have switches are
///      led away by all that see something, and by these alone;
///  (6) `programme`: where changes lead a link into space that was not seen to be free (SensedSpace), none of
///      its ends goes farther than λ, to second order: what is there is sensed before links get to it;
///  (7) the same calls give the same changes.
class LinkMotion {
 public:
  LinkMotion(const kinematics::Robot&, const LinkParameters&);
  LinkMotion(const LinkMotion&) = delete;
  LinkMotion& operator=(const LinkMotion&) = delete;

  const LinkParameters& parameters() const { return parameters_; }
  const LinkGuard& guard() const { return guard_; }
  /// Are motions checked, and can they be judged beforehand? By the programme they are.
  bool is_checked() const { return parameters_.redundancy == Redundancy::programme; }

  /// Takes in what a set has told. To be called once for each set, in order, before anything is asked about
  /// it; all answers are for its posture. Its model must stay as it is as long as anything is asked.
  void look(const Observation&);
  /// The changes that the robot is to make after this set, whoever has chosen them.
  void told(const kinematics::Configuration& changes) { watch_.told(robot_, changes); }
  /// The joints that did not do what they were told (JointWatch).
  std::vector<std::size_t> stuck_joints() const { return watch_.stuck(); }

  // Precondition of all that follows: look() has been called.

  const Obstacles& obstacles() const { return *obstacles_; }
  const SensedSpace& sensed() const { return sensed_; }
  /// Do all links lie in space that was seen to be free (SensedSpace)?
  bool is_sensed(const kinematics::Posture&) const;
  /// Smallest distance of a link from the model and from readings that it does not have, as far as the
  /// objective's influence; infinite beyond.
  double clearance() const { return clearance_; }

  /// The changes for a motion of the control point (world, scan's unit).
  kinematics::Configuration changes(const Eigen::Vector3d& motion);
  /// The longest step straight towards a configuration that is clear; none: zero. Precondition: is_checked().
  kinematics::Configuration towards(const kinematics::Configuration&) const;
  /// The posture to which such changes, one after the other and without halving, would bring the control
  /// point to this place in a few steps more than its way takes, by what is known now; none: they do not.
  /// Only where steps end is looked at. Precondition: is_checked().
  std::optional<kinematics::Posture> reaching(const Eigen::Vector3d& place);
  /// The same for any task, from any configuration, to a tenth of λ.
  std::optional<kinematics::Posture> led_clear(const kinematics::Configuration& from, const TaskIn&);

 private:
  std::optional<kinematics::Posture> led(kinematics::Posture from, const TaskIn&,
                                         std::span<const std::size_t> seeing);
  Eigen::VectorXd reconfiguration_by_thesis() const;
  kinematics::Configuration by_thesis(const Eigen::Vector3d& motion);
  kinematics::Configuration way_out() const;
  kinematics::Configuration careful(const kinematics::Configuration& way) const;
  void hold_stuck_joints(const kinematics::Configuration& here);

  kinematics::Robot robot_;  ///< stuck joints have their limits where they are
  LinkParameters parameters_;
  JointWatch watch_;
  LinkGuard guard_;
  StepProgramme programme_;
  UnmodelledReadings readings_;
  SensedSpace sensed_;
  std::optional<Obstacles> obstacles_;
  std::optional<kinematics::Posture> posture_;
  std::vector<std::size_t> seeing_;       ///< switches, in that posture
  std::vector<std::size_t> unexplained_;  ///< of these, what no polygon of the model is in the fields of
  double clearance_ = 0;
};

}  // namespace limpet::following
