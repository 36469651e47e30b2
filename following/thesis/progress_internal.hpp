// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <optional>
#include <vector>

#include <limpet/kinematics/posture.hpp>

namespace limpet::following::internal {

/// Does the robot get anywhere (thesis §3.4.7)? Every τ steps its configuration is compared with the one τ
/// steps before, joints of each kind with the ceiling γ on their changes. A robot that goes round in a circle
/// passes this test, so that the last 2 τ configurations must also not all lie within 3 γ of their mean.
class Progress {
 public:
  /// `period`: τ ≥ 2. `longest_step`: stands for γ of prismatic joints without a ceiling, and `angle_rad` for
  /// that of revolute ones.
  Progress(int period, double longest_step, double angle_rad)
      : period_(period), longest_step_(longest_step), angle_rad_(angle_rad) {
    restart(longest_step);
  }

  /// Counts a step.
  void step(const kinematics::Posture&);
  /// A new goal has been chosen here: counting starts again. `way`: how far it is to it and along it, scan's
  /// unit; a robot that has not come there after many times the steps that this takes goes round in a circle
  /// that is wider than the window shows.
  void restart(double way);
  /// As of the last step; until restart().
  bool is_insufficient() const { return insufficient_; }
  /// Has the robot stood still for so many periods of τ steps, whatever goals were chosen?
  bool stands_still(int periods) const { return still_ >= periods * period_; }

 private:
  using Configuration = kinematics::Configuration;
  bool is_near(const kinematics::Robot&, const Configuration&, const Configuration&, double ceilings) const;
  bool circles(const kinematics::Robot&) const;

  int period_;
  double longest_step_, angle_rad_;
  std::vector<Configuration> window_;  ///< since the restart, at most the last 2 τ + 1
  int steps_ = 0;                      ///< since the restart
  double most_steps_ = 0;              ///< until the goal must be reached
  bool insufficient_ = false;
  std::optional<Configuration> last_;
  int still_ = 0;  ///< steps since the robot moved
};

}  // namespace limpet::following::internal
