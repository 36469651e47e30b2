// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/kinematics/robot.hpp>

#include <algorithm>
#include <cmath>
#include <limpet/kinematics/sensor_patterns.hpp>
#include <stdexcept>
#include <utility>

namespace limpet::kinematics {
namespace {

void require(bool good, const std::string& what) {
  if (!good) throw std::invalid_argument(what);
}

constexpr double kRounding = 1e-9;

bool is_unit(const Eigen::Vector3d& v) { return std::abs(v.norm() - 1) < kRounding; }

bool is_rigid(const Eigen::Isometry3d& pose) {
  const Eigen::Matrix3d turn = pose.linear();
  return pose.translation().allFinite() && (turn * turn.transpose()).isIdentity(kRounding) &&
         turn.determinant() > 0;
}

bool is_sound(const model::Capsule& part) {
  return part.a.allFinite() && part.b.allFinite() && part.radius >= 0 && std::isfinite(part.radius);
}

void require_sound(const Link& link, std::size_t i) {
  const std::string where = "link " + std::to_string(i) + " (" + link.name + ")";
  require(!link.parent || *link.parent < i, where + ": its parent must come before it");
  require(is_rigid(link.mounting), where + ": its mounting must be a finite translation and a rotation");
  require(is_unit(link.joint.axis), where + ": the axis of its joint must be a unit vector");
  require(link.joint.low <= link.joint.high, where + ": the limits of its joint are out of order");
  require(link.joint.max_velocity > 0, where + ": the largest velocity of its joint must be positive");
  require(std::all_of(link.body.begin(), link.body.end(), is_sound),
          where + ": a part of its body must have finite ends and a radius of 0 or more");
}

template <class Mounted>
void require_mounted(const Robot& robot, const Mounted& sensor, const std::string& where) {
  require(sensor.link < robot.links.size(), where + ": is on no link");
  require(sensor.position.allFinite(), where + ": has no finite position");
  require(is_unit(sensor.axis), where + ": its axis must be a unit vector");
  require(sensor.range > 0, where + ": its range must be positive");
}

bool is_at(const ControlPoint& point, const RangeSensor& sensor) {
  return sensor.link == point.link && sensor.position == point.position;
}

}  // namespace

Eigen::Isometry3d motion_of(const Joint& joint, double position) {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  if (joint.kind == Joint::Kind::prismatic) motion.translation() = position * joint.axis;
  if (joint.kind == Joint::Kind::revolute)
    motion.linear() = Eigen::AngleAxisd(position, joint.axis).toRotationMatrix();
  return motion;
}

std::size_t Robot::joint_count() const {
  return static_cast<std::size_t>(std::count_if(
      links.begin(), links.end(), [](const Link& link) { return link.joint.kind != Joint::Kind::fixed; }));
}

void require_sound(const Robot& robot) {
  for (std::size_t i = 0; i < robot.links.size(); ++i) require_sound(robot.links[i], i);
  require(robot.control_point.link < robot.links.size(), "the control point is on no link");
  require(robot.control_point.position.allFinite(), "the control point has no finite position");
  for (std::size_t i = 0; i < robot.sensors.size(); ++i)
    require_mounted(robot, robot.sensors[i], "sensor " + std::to_string(i));
  for (std::size_t i = 0; i < robot.switches.size(); ++i) {
    const std::string where = "switch " + std::to_string(i);
    require_mounted(robot, robot.switches[i], where);
    require(std::isfinite(robot.switches[i].range), where + ": its range must be finite");
  }
  require(robot.ceilings.prismatic > 0 && robot.ceilings.revolute_rad > 0, "ceilings must be positive");
}

Robot placed(Robot robot, const Eigen::Isometry3d& base) {
  for (Link& link : robot.links)
    if (!link.parent) link.mounting = base * link.mounting;
  return robot;
}

Robot with_switches(Robot robot) {
  std::vector<RangeSensor> at_control_point;
  for (const RangeSensor& sensor : robot.sensors)
    if (is_at(robot.control_point, sensor))
      at_control_point.push_back(sensor);
    else
      robot.switches.push_back({sensor.link, sensor.position, sensor.axis, sensor.range});
  robot.sensors = std::move(at_control_point);
  return robot;
}

Robot point_robot(const PointRobotOptions& options) {
  Robot robot;
  robot.name = "point";
  robot.ceilings.prismatic = options.ceiling;
  for (int i = 0; i < 3; ++i) {
    Link link;
    link.name = std::string(1, static_cast<char>('x' + i));
    if (i > 0) link.parent = static_cast<std::size_t>(i - 1);
    link.joint = {Joint::Kind::prismatic, Eigen::Vector3d::Unit(i)};
    robot.links.push_back(link);
  }
  Link body;
  body.name = "body";
  body.parent = 2;
  body.mounting.linear() = options.heading.normalized().toRotationMatrix();
  robot.links.push_back(body);
  robot.control_point.link = 3;
  robot.sensors = ball({.link = 3, .range = options.sensing_range});
  require_sound(robot);
  return robot;
}

}  // namespace limpet::kinematics
