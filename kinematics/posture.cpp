// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/kinematics/posture.hpp>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace limpet::kinematics {
namespace {

bool moves(const Link& link) { return link.joint.kind != Joint::Kind::fixed; }

}  // namespace

Posture::Posture(const Robot& robot, const Configuration& configuration)
    : robot_(&robot), configuration_(configuration) {
  if (static_cast<std::size_t>(configuration.size()) != robot.joint_count() || !configuration.allFinite())
    throw std::invalid_argument("a configuration must have one finite position for each joint");
  Eigen::Index joint = 0;
  for (const Link& link : robot.links) {
    Eigen::Isometry3d pose = link.parent ? links_[*link.parent] * link.mounting : link.mounting;
    if (moves(link)) pose = pose * motion_of(link.joint, configuration[joint++]);
    links_.push_back(pose);
  }
}

Eigen::Vector3d Posture::control_point() const {
  return links_[robot_->control_point.link] * robot_->control_point.position;
}

Posture::Sensor Posture::sensor(std::size_t i) const {
  const RangeSensor& sensor = robot_->sensors[i];
  const Eigen::Isometry3d& link = links_[sensor.link];
  return {link * sensor.position, link.linear() * sensor.axis, sensor.range};
}

Posture::Switch Posture::proximity_switch(std::size_t i) const {
  const ProximitySwitch& s = robot_->switches[i];
  const Eigen::Isometry3d& link = links_[s.link];
  return {link * s.position, link.linear() * s.axis, link * s.field_centre(), s.range};
}

model::SensorPoint Posture::sensor_point(std::size_t i, double distance) const {
  const Sensor s = sensor(i);
  return {s.position + distance * s.axis, s.axis, distance};
}

Eigen::Matrix3Xd Posture::jacobian() const { return jacobian(robot_->control_point.link, control_point()); }

Eigen::Matrix3Xd Posture::jacobian(std::size_t of_link, const Eigen::Vector3d& x) const {
  Eigen::Matrix3Xd jacobian = Eigen::Matrix3Xd::Zero(3, configuration_.size());
  std::vector<bool> carries(robot_->links.size());  // does the link carry the one asked about?
  for (std::optional<std::size_t> i = of_link; i; i = robot_->links[*i].parent) carries[*i] = true;
  Eigen::Index joint = 0;
  for (std::size_t i = 0; i < robot_->links.size(); ++i) {
    const Link& link = robot_->links[i];
    if (!moves(link)) continue;
    const Eigen::Index column = joint++;
    if (!carries[i]) continue;
    const Eigen::Vector3d axis = links_[i].linear() * link.joint.axis;  // the joint leaves its axis as it is
    if (link.joint.kind == Joint::Kind::prismatic)
      jacobian.col(column) = axis;
    else
      jacobian.col(column) = axis.cross(x - links_[i].translation());
  }
  return jacobian;
}

Configuration actuator_changes(const Posture& posture, const Eigen::Vector3d& motion) {
  const Eigen::MatrixXd jacobian = posture.jacobian();
  if (jacobian.cols() == 0) return Configuration();  // which the decomposition does not take
  return limited(posture, jacobian.completeOrthogonalDecomposition().solve(motion));
}

LengthsByKind lengths_by_kind(const Robot& robot, const Eigen::VectorXd& changes) {
  double prismatic2 = 0, revolute2 = 0;
  for_each_moving_joint(robot, [&](Eigen::Index k, const Joint& joint) {
    (joint.kind == Joint::Kind::prismatic ? prismatic2 : revolute2) += changes[k] * changes[k];
  });
  return {std::sqrt(prismatic2), std::sqrt(revolute2)};
}

Configuration within_limits(const Robot& robot, Configuration at) {
  for_each_moving_joint(
      robot, [&](Eigen::Index k, const Joint& joint) { at[k] = std::clamp(at[k], joint.low, joint.high); });
  return at;
}

Configuration limited(const Posture& posture, const Configuration& changes) {
  const Robot& robot = posture.robot();
  double scale = 1;
  for_each_moving_joint(robot, [&](Eigen::Index k, const Joint& joint) {
    const double change = changes[k], at = posture.configuration()[k];
    const double room = change > 0 ? joint.high - at : at - joint.low;
    if (std::abs(change) > room) scale = std::min(scale, std::max(0.0, room) / std::abs(change));
  });
  const LengthsByKind length = lengths_by_kind(robot, changes);
  if (length.prismatic > 0) scale = std::min(scale, robot.ceilings.prismatic / length.prismatic);
  if (length.revolute_rad > 0) scale = std::min(scale, robot.ceilings.revolute_rad / length.revolute_rad);
  return scale * changes;
}

}  // namespace limpet::kinematics
