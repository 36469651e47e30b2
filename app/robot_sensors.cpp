// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <functional>
#include <limpet/kinematics/sensor_patterns.hpp>
#include <map>
#include <numbers>
#include <stdexcept>

#include "robot_sensors_internal.hpp"

namespace limpet::app::internal {
namespace {

using Eigen::Vector3d;
using kinematics::RangeSensor;
using kinematics::Robot;

constexpr double kRadians = std::numbers::pi / 180;
constexpr std::int64_t kMostSensors = 100'000;

/// What all patterns have.
struct Common {
  std::size_t link = 0;
  double range = 0;
};

double read_angle(const TomlSection& sensors, const std::string& key, double otherwise_rad) {
  const auto degrees = sensors.number(key, Numbers::any);
  return degrees ? *degrees * kRadians : otherwise_rad;
}

std::size_t read_count(const TomlSection& sensors, const std::string& key) {
  sensors.require_one({key}, true);
  return static_cast<std::size_t>(*sensors.whole(key, 1, kMostSensors));
}

Vector3d needed_vector(const TomlSection& sensors, const std::string& key) {
  sensors.require_one({key}, true);
  return *sensors.vector(key);
}

double needed_length(const TomlSection& sensors, const std::string& key, Numbers which) {
  sensors.require_one({key}, true);
  return *sensors.number(key, which);
}

std::vector<RangeSensor> read_ring(const Robot&, const TomlSection& sensors, const Common& common) {
  kinematics::Ring ring;
  ring.link = common.link, ring.range = common.range;
  ring.centre = needed_vector(sensors, "centre");
  ring.axis = needed_vector(sensors, "axis");
  ring.radius = needed_length(sensors, "radius", Numbers::not_negative);
  ring.count = read_count(sensors, "count");
  ring.tilt_rad = read_angle(sensors, "tilt_deg", 0);
  ring.turn_rad = read_angle(sensors, "turn_deg", 0);
  return kinematics::ring(ring);
}

std::vector<RangeSensor> read_rings(const Robot&, const TomlSection& sensors, const Common& common) {
  kinematics::Rings rings;
  rings.link = common.link, rings.range = common.range;
  rings.from = needed_vector(sensors, "from");
  rings.to = needed_vector(sensors, "to");
  rings.rings = read_count(sensors, "rings");
  rings.radius = needed_length(sensors, "radius", Numbers::not_negative);
  rings.count = read_count(sensors, "count");
  rings.tilt_rad = read_angle(sensors, "tilt_deg", 0);
  rings.staggered = !sensors.flag("aligned");
  return kinematics::rings(rings);
}

std::vector<RangeSensor> read_patch(const Robot&, const TomlSection& sensors, const Common& common) {
  kinematics::Patch patch;
  patch.link = common.link, patch.range = common.range;
  patch.centre = needed_vector(sensors, "centre");
  patch.along = needed_vector(sensors, "along");
  patch.across = needed_vector(sensors, "across");
  patch.columns = read_count(sensors, "columns");
  patch.rows = read_count(sensors, "rows");
  return kinematics::patch(patch);
}

std::vector<RangeSensor> read_ball(const Robot& robot, const TomlSection& sensors, const Common& common) {
  kinematics::Ball ball;
  ball.link = common.link, ball.range = common.range;
  const bool at_control_point = common.link == robot.control_point.link;
  ball.centre =
      sensors.vector("centre").value_or(at_control_point ? robot.control_point.position : Vector3d::Zero());
  ball.without = sensors.vector("without");
  ball.without_rad = read_angle(sensors, "without_deg", ball.without_rad);
  return kinematics::ball(ball);
}

std::vector<RangeSensor> read_skin(const Robot& robot, const TomlSection& sensors, const Common& common) {
  kinematics::Skin skin;
  skin.link = common.link, skin.range = common.range;
  skin.spacing = sensors.number("spacing", Numbers::positive).value_or(common.range / 2);
  if (sensors.has("count")) skin.count = read_count(sensors, "count");
  return kinematics::skin(robot, skin);
}

struct Pattern {
  std::vector<std::string> keys;
  std::function<std::vector<RangeSensor>(const Robot&, const TomlSection&, const Common&)> read;
};

const std::map<std::string, Pattern>& patterns() {
  static const std::map<std::string, Pattern> all = {
      {"ball", {{"pattern", "link", "range", "centre", "without", "without_deg"}, read_ball}},
      {"patch", {{"pattern", "link", "range", "centre", "along", "across", "columns", "rows"}, read_patch}},
      {"ring",
       {{"pattern", "link", "range", "centre", "axis", "radius", "count", "tilt_deg", "turn_deg"},
        read_ring}},
      {"rings",
       {{"pattern", "link", "range", "from", "to", "rings", "radius", "count", "tilt_deg", "aligned"},
        read_rings}},
      {"skin", {{"pattern", "link", "range", "spacing", "count"}, read_skin}}};
  return all;
}

std::vector<std::string> all_keys() {
  std::vector<std::string> keys = {"pattern"};
  for (const auto& [name, pattern] : patterns())
    for (const std::string& key : pattern.keys)
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
  return keys;
}

const Pattern& pattern_of(const TomlSection& sensors) {
  const std::string name = sensors.text("pattern").value_or("");
  const auto found = patterns().find(name);
  if (found == patterns().end())
    sensors.fail("pattern",
                 sensors.called("pattern") + " must be \"ball\", \"patch\", \"ring\", \"rings\" or \"skin\"");
  sensors.allow(found->second.keys);
  return found->second;
}

}  // namespace

std::size_t link_of(const Robot& robot, const TomlSection& section, const std::string& key) {
  const auto name = section.text(key);
  if (!name) return robot.control_point.link;
  std::string known;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (robot.links[i].name == *name) return i;
    known += (i > 0 ? ", " : "") + robot.links[i].name;
  }
  section.fail(key, section.called(key) + " is no link of the robot; its links are " + known);
}

std::vector<RangeSensor> read_sensors(const Robot& robot, const TomlSection& file, double range) {
  std::vector<RangeSensor> all;
  file.each("sensors", all_keys(), [&](const TomlSection& sensors) {
    const Pattern& pattern = pattern_of(sensors);
    const Common common{link_of(robot, sensors, "link"),
                        sensors.number("range", Numbers::positive).value_or(range)};
    try {
      const std::vector<RangeSensor> more = pattern.read(robot, sensors, common);
      all.insert(all.end(), more.begin(), more.end());
    } catch (const std::invalid_argument& error) {
      sensors.fail("", error.what());
    }
    if (all.size() > static_cast<std::size_t>(kMostSensors))
      sensors.fail("", "a robot has at most 100000 sensors");
  });
  return all;
}

}  // namespace limpet::app::internal
