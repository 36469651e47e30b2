// Copyright the limpet authors. GPL-3.0-or-later.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limpet/evaluation/moved_body_internal.hpp>
#include <optional>

namespace limpet::evaluation {
namespace {

using Eigen::Vector3d;
using kinematics::Posture;
using kinematics::Robot;

bool is_moved_by_a_joint(const Robot& robot, std::size_t link) {
  if (robot.links[link].joint.kind != kinematics::Joint::Kind::fixed) return true;
  return robot.links[link].parent && is_moved_by_a_joint(robot, *robot.links[link].parent);
}

/// The first link of the rigid body, of links with fixed joints between them, that a link is part of.
std::size_t rigid_body_of(const Robot& robot, std::size_t link) {
  while (robot.links[link].joint.kind == kinematics::Joint::Kind::fixed && robot.links[link].parent)
    link = *robot.links[link].parent;
  return link;
}

bool has_extent(const Robot& robot, std::size_t rigid_body) {
  for (std::size_t i = 0; i < robot.links.size(); ++i)
    if (!robot.links[i].body.empty() && rigid_body_of(robot, i) == rigid_body) return true;
  return false;
}

/// The rigid body that one hangs on, past those without extent.
std::optional<std::size_t> carrier_of(const Robot& robot, std::size_t rigid_body) {
  const auto next = [&](std::size_t body) -> std::optional<std::size_t> {
    const auto parent = robot.links[body].parent;
    if (!parent) return std::nullopt;
    return rigid_body_of(robot, *parent);
  };
  std::optional<std::size_t> carrier = next(rigid_body);
  while (carrier && !has_extent(robot, *carrier)) carrier = next(*carrier);
  return carrier;
}

bool are_joined(const Robot& robot, std::size_t link, std::size_t other) {
  const std::size_t one = rigid_body_of(robot, link), two = rigid_body_of(robot, other);
  return one == two || carrier_of(robot, one) == two || carrier_of(robot, two) == one;
}

/// All joints at 0, or at the limit that is nearest to it.
kinematics::Configuration at_rest(const Robot& robot) {
  kinematics::Configuration rest(static_cast<Eigen::Index>(robot.joint_count()));
  Eigen::Index k = 0;
  for (const kinematics::Link& link : robot.links)
    if (link.joint.kind != kinematics::Joint::Kind::fixed)
      rest[k++] = std::clamp(0.0, link.joint.low, link.joint.high);
  return rest;
}

/// Distance between two segments: at ends, or between interior points where these are nearest.
double distance_of_axes(const model::Capsule& p, const model::Capsule& q) {
  const auto to = [](const Vector3d& x, const model::Capsule& c) {
    const Vector3d along = c.b - c.a;
    const double length2 = along.squaredNorm();
    const double t = length2 > 0 ? std::clamp((x - c.a).dot(along) / length2, 0.0, 1.0) : 0;
    return (c.a + t * along - x).norm();
  };
  double least = std::min({to(p.a, q), to(p.b, q), to(q.a, p), to(q.b, p)});
  const Vector3d u = p.b - p.a, v = q.b - q.a, normal = u.cross(v);
  const double n2 = normal.squaredNorm();
  if (n2 > 0) {
    const Vector3d between = q.a - p.a;
    const double s = between.cross(v).dot(normal) / n2, t = between.cross(u).dot(normal) / n2;
    if (s > 0 && s < 1 && t > 0 && t < 1)
      least = std::min(least, std::abs(between.dot(normal)) / std::sqrt(n2));
  }
  return least;
}

}  // namespace

MovedBody::MovedBody(const Robot& robot, const kinematics::Configuration& first) {
  for (std::size_t i = 0; i < robot.links.size(); ++i)
    if (is_moved_by_a_joint(robot, i))
      for (const model::Capsule& capsule : robot.links[i].body) parts_.push_back({i, capsule});
  const std::vector<model::Capsule> at_first = in_world(Posture(robot, first)),
                                    resting = in_world(Posture(robot, at_rest(robot)));
  const auto touch = [](const std::vector<model::Capsule>& parts, std::size_t i, std::size_t j) {
    return gap_between(parts[i], parts[j]) <= 0;
  };
  for (std::size_t i = 0; i < parts_.size(); ++i)
    for (std::size_t j = i + 1; j < parts_.size(); ++j)
      if (!are_joined(robot, parts_[i].link, parts_[j].link) && !touch(at_first, i, j) &&
          !touch(resting, i, j))
        pairs_.emplace_back(i, j);
}

std::vector<model::Capsule> MovedBody::in_world(const Posture& posture) const {
  std::vector<model::Capsule> capsules;
  for (const MovedPart& part : parts_) {
    const Eigen::Isometry3d& pose = posture.link(part.link);
    capsules.push_back({pose * part.capsule.a, pose * part.capsule.b, part.capsule.radius});
  }
  return capsules;
}

double gap_between(const model::Capsule& p, const model::Capsule& q) {
  return distance_of_axes(p, q) - p.radius - q.radius;
}

}  // namespace limpet::evaluation
