// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/kinematics/robot.hpp>

namespace limpet::evaluation {

/// For each joint that moves, how far a unit of its motion (a radian, a length) moves a point of a link at
/// most, in any configuration within the limits; 0 for a joint that does not carry it. `point` is in the
/// link's frame. Infinite for a revolute joint that carries a prismatic one without limits.
Eigen::VectorXd joint_levers(const kinematics::Robot&, std::size_t link, const Eigen::Vector3d& point);

/// A ball that holds a point of a link in every configuration within the limits. World frame.
struct ReachBall {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0;
};
ReachBall reach_of_point(const kinematics::Robot&, std::size_t link, const Eigen::Vector3d& point);

}  // namespace limpet::evaluation
