// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/kinematics/arm.hpp>

#include <limpet/kinematics/sensor_patterns.hpp>
#include <stdexcept>
#include <string>

namespace limpet::kinematics {
namespace {

using Eigen::Vector3d;

/// Links 2 to 4 are the third, fifth and seventh of the robot.
std::size_t index_of(std::size_t number) { return 2 * (number - 1); }

Link on_top(const Robot& robot, const std::string& name, double height, const Vector3d& axis) {
  Link link;
  link.name = name;
  link.parent = robot.links.size() - 1;
  link.mounting.translation() = height * Vector3d::UnitZ();
  link.joint = {Joint::Kind::revolute, axis};
  return link;
}

void add(std::vector<RangeSensor>& sensors, const std::vector<RangeSensor>& more) {
  sensors.insert(sensors.end(), more.begin(), more.end());
}

}  // namespace

ArmOptions scaled(ArmOptions options, double factor) {
  options.link_length *= factor;
  options.radius *= factor;
  options.sensing_range *= factor;
  options.bare_tip *= factor;
  return options;
}

Robot arm(const ArmOptions& options) {
  const double length = options.link_length, radius = options.radius;
  const double tip =
      length - options.bare_tip - radius;  // where link 4's capsule ends, but for its round end
  if (!(length > 0 && radius >= 0 && options.bare_tip >= 0 && tip > length / 10))
    throw std::invalid_argument("the links of an arm must be longer than they are thick");
  Robot robot;
  robot.name = "arm";
  robot.ceilings.revolute_rad = options.ceiling_rad;
  Link base;
  base.name = "link1";
  base.body = {{Vector3d::Zero(), Vector3d(0, 0, length), radius}};
  robot.links.push_back(base);
  for (std::size_t number = 2; number <= 4; ++number) {
    robot.links.push_back(on_top(robot, "turn" + std::to_string(number), length, Vector3d::UnitX()));
    robot.links.push_back(on_top(robot, "link" + std::to_string(number), 0, Vector3d::UnitY()));
    robot.links.back().body = {{Vector3d::Zero(), Vector3d(0, 0, number < 4 ? length : tip), radius}};
  }
  const Vector3d end(0, 0, length);
  robot.control_point = {index_of(4), end};
  robot.sensors = ball({index_of(4), end, -Vector3d::UnitZ(), Ball().without_rad, options.sensing_range});
  for (std::size_t number = 2; number <= 4; ++number) {
    Rings skin;
    skin.link = index_of(number);
    skin.rings = number < 4 ? 10 : 9;
    skin.from = Vector3d(0, 0, 0.05 * length);
    skin.to = Vector3d(0, 0, (number < 4 ? 0.95 : 0.85) * length);
    skin.radius = radius;
    skin.count = 4;
    skin.range = options.sensing_range;
    add(robot.sensors, rings(skin));
  }
  require_sound(robot);
  return robot;
}

}  // namespace limpet::kinematics
