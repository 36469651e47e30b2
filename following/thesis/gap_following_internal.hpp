// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "pursuit_internal.hpp"
#include "situation_internal.hpp"

namespace limpet::following::internal {

/// Gap following (thesis §3.4.5): moves a sensor's axis to one target point of the gap after the other, until
/// a sensor point is detected near each.
class GapFollowing {
 public:
  /// Sets target points between the current point and the closest surface model point. `from`: the mode that
  /// detected the gap.
  void begin(const Situation&, Pursuit&, const Eigen::Vector3d& current_point, Mode from);
  /// Current segment following when the gap is closed; the mode that detected the gap when the targets are
  /// used.
  Decision follow(const Situation&, Pursuit&);

  /// Has the robot been moved since begin()?
  bool has_moved() const { return moved_; }
  /// The target points that are left, the one whose turn it is first.
  std::vector<Eigen::Vector3d> targets() const;

 private:
  bool is_over(const Situation&, const Pursuit&) const;
  bool is_detected(const Situation&) const;
  void next(const Situation&, Pursuit&);
  void choose_sensor(const Situation&);

  Mode from_ = Mode::current_edge;
  std::vector<Eigen::Vector3d> targets_;
  std::size_t target_ = 0;
  std::size_t sensor_ = 0;  ///< the controlled sensor
  bool moved_ = false;
};

/// The point of a sensor's axis, within its range, that is nearest to a target.
Eigen::Vector3d nearest_on_axis(const kinematics::Posture::Sensor&, const Eigen::Vector3d& target);

}  // namespace limpet::following::internal
