// Copyright the limpet authors. GPL-3.0-or-later.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limpet/evaluation/joint_levers_internal.hpp>
#include <optional>
#include <vector>

namespace limpet::evaluation {
namespace {

using Eigen::Vector3d;
using kinematics::Joint;
using kinematics::Link;
using kinematics::Robot;

/// The number of each link's joint among those that move; −1: it is fixed.
std::vector<Eigen::Index> joints_of(const Robot& robot) {
  std::vector<Eigen::Index> joints;
  Eigen::Index next = 0;
  for (const Link& link : robot.links) joints.push_back(link.joint.kind == Joint::Kind::fixed ? -1 : next++);
  return joints;
}

/// A ball in a link's frame, seen from the joint's frame: it holds what the ball did in every position.
ReachBall moved_by(const Joint& joint, const ReachBall& ball) {
  const Vector3d on_axis = ball.centre.dot(joint.axis) * joint.axis;
  switch (joint.kind) {
    case Joint::Kind::fixed:
      return ball;
    case Joint::Kind::revolute:
      return {on_axis, (ball.centre - on_axis).norm() + ball.radius};
    case Joint::Kind::prismatic:
      break;
  }
  const double half = (joint.high - joint.low) / 2;
  if (!std::isfinite(half)) return {ball.centre, std::numeric_limits<double>::infinity()};
  return {ball.centre + (joint.low + half) * joint.axis, ball.radius + half};
}

double lever_of(const Joint& joint, const ReachBall& ball) {
  if (joint.kind == Joint::Kind::prismatic) return 1;
  return ball.centre.cross(joint.axis).norm() + ball.radius;
}

/// Goes from a link to the root, and tells each joint on the way with the ball in its link's frame. Returns
/// the ball in the world.
template <class Tell>
ReachBall towards_root(const Robot& robot, std::size_t link, const Vector3d& point, const Tell& tell) {
  ReachBall ball{point, 0};
  for (std::optional<std::size_t> i = link; i; i = robot.links[*i].parent) {
    const Link& here = robot.links[*i];
    tell(*i, ball);
    ball = moved_by(here.joint, ball);
    ball.centre = here.mounting * ball.centre;
  }
  return ball;
}

}  // namespace

Eigen::VectorXd joint_levers(const Robot& robot, std::size_t link, const Vector3d& point) {
  const std::vector<Eigen::Index> joints = joints_of(robot);
  Eigen::VectorXd levers = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(robot.joint_count()));
  towards_root(robot, link, point, [&](std::size_t i, const ReachBall& ball) {
    if (joints[i] >= 0) levers[joints[i]] = lever_of(robot.links[i].joint, ball);
  });
  return levers;
}

ReachBall reach_of_point(const Robot& robot, std::size_t link, const Vector3d& point) {
  return towards_root(robot, link, point, [](std::size_t, const ReachBall&) {});
}

}  // namespace limpet::evaluation
