// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>

#include <limpet/following/clearance.hpp>
#include <limpet/kinematics/posture.hpp>
#include <limpet/model/view.hpp>

namespace limpet::following::internal {

/// Leads motions along surfaces that are in their way.
class Steering {
 public:
  /// `step`: the longest motion, > 0. What is given by reference must outlive this.
  Steering(const model::View& view, const Clearance& clearance, const kinematics::Posture& posture,
           double step)
      : view_(view), clearance_(clearance), posture_(posture), here_(posture.control_point()), step_(step) {}

  /// A motion to `there`, or a step towards it, that goes straight, if that is safe, or else along the
  /// surface that is in the way, and off it; where it is too narrow to be safe, one of the two that is clear;
  /// else a step along a sensing axis round what is in the way; and else the way out: the clear motion along
  /// a sensing axis that leads farthest from what is near, or zero.
  ///
  ///  (1) it is no longer than the step;
  ///  (2) it is clear (Clearance::is_clear), or zero.
  Eigen::Vector3d towards(const Eigen::Vector3d& there) const;
  /// A motion straight to `there`, or a step of it.
  Eigen::Vector3d straight(const Eigen::Vector3d& there) const { return shortened(there - here_); }
  /// Is the straight way clear?
  bool is_clear(const Eigen::Vector3d& there) const { return clearance_.is_clear(view_, here_, there); }
  /// Does the straight way keep off everything, with some room to spare?
  bool is_safe(const Eigen::Vector3d& there) const;

 private:
  Eigen::Vector3d shortened(const Eigen::Vector3d& motion) const;
  Eigen::Vector3d bent_off(const Eigen::Vector3d& motion) const;
  Eigen::Vector3d way_round(const Eigen::Vector3d& there) const;
  Eigen::Vector3d way_out() const;

  const model::View& view_;
  const Clearance& clearance_;
  const kinematics::Posture& posture_;
  Eigen::Vector3d here_;
  double step_;
};

}  // namespace limpet::following::internal
