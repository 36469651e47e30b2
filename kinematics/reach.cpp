// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/kinematics/reach.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace limpet::kinematics {
namespace {

using Eigen::Vector3d;

/// A ball in the frame of a link, that holds something of the robot in every configuration.
struct Part {
  Vector3d centre;
  double radius = 0;
};

double from_origin(const Part& part) { return part.centre.norm() + part.radius; }

double from_axis(const Part& part, const Vector3d& axis) {
  return (part.centre - part.centre.dot(axis) * axis).norm() + part.radius;
}

/// What is on each link itself.
std::vector<std::vector<Part>> parts_of(const Robot& robot) {
  std::vector<std::vector<Part>> parts(robot.links.size());
  for (std::size_t i = 0; i < robot.links.size(); ++i)
    for (const model::Capsule& part : robot.links[i].body) {
      parts[i].push_back({part.a, part.radius});
      parts[i].push_back({part.b, part.radius});
    }
  for (const RangeSensor& sensor : robot.sensors) parts[sensor.link].push_back({sensor.position, 0});
  for (const ProximitySwitch& s : robot.switches) parts[s.link].push_back({s.position, 0});
  parts[robot.control_point.link].push_back({robot.control_point.position, 0});
  return parts;
}

/// What a link carries, seen from its parent: as it is where the joint is fixed; else the ball about the
/// joint's origin that holds it however it turns, at both ends of the way on which a prismatic joint slides.
std::vector<Part> seen_from_parent(const Link& link, const std::vector<Part>& parts) {
  std::vector<Part> seen;
  if (link.joint.kind == Joint::Kind::fixed) {
    for (const Part& part : parts) seen.push_back({link.mounting * part.centre, part.radius});
    return seen;
  }
  if (parts.empty()) return seen;
  double radius = 0;
  for (const Part& part : parts) radius = std::max(radius, from_origin(part));
  const Vector3d origin = link.mounting.translation();
  if (link.joint.kind == Joint::Kind::revolute) return {{origin, radius}};
  const double reach = std::max(std::abs(link.joint.low), std::abs(link.joint.high));
  if (std::isinf(reach)) return {{origin, reach}};
  const Vector3d axis = link.mounting.linear() * link.joint.axis;
  return {{origin + link.joint.low * axis, radius}, {origin + link.joint.high * axis, radius}};
}

bool has_joint(const Robot& robot, Joint::Kind kind) {
  return std::any_of(robot.links.begin(), robot.links.end(),
                     [kind](const Link& link) { return link.joint.kind == kind; });
}

}  // namespace

double largest_reach(const Robot& robot) {
  std::vector<std::vector<Part>> parts = parts_of(robot);
  double reach = 0;
  for (std::size_t i = robot.links.size(); i-- > 0;) {  // what is carried comes before what carries it
    const Link& link = robot.links[i];
    if (link.joint.kind == Joint::Kind::revolute)
      for (const Part& part : parts[i]) reach = std::max(reach, from_axis(part, link.joint.axis));
    if (!link.parent) continue;
    const std::vector<Part> seen = seen_from_parent(link, parts[i]);
    parts[*link.parent].insert(parts[*link.parent].end(), seen.begin(), seen.end());
  }
  return reach;
}

Ceilings ceilings_for(const Robot& robot, double sensing_range) {
  const bool slides = has_joint(robot, Joint::Kind::prismatic);
  const double reach = largest_reach(robot);
  if (std::isinf(reach))
    throw std::invalid_argument("a prismatic joint beyond a revolute one has no limits: give them");
  const double share = slides && reach > 0 ? sensing_range / 2 : sensing_range;
  Ceilings ceilings;
  if (slides) ceilings.prismatic = share;
  if (reach > 0) ceilings.revolute_rad = share / reach;
  return ceilings;
}

}  // namespace limpet::kinematics
