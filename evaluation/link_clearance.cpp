// Copyright the limpet authors. GPL-3.0-or-later.
//
// Shares no code with what keeps links away in a run, but for where links are.
#include <limpet/evaluation/link_clearance.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace limpet::evaluation {
namespace internal {

/// Of a link.
struct WatchedPart {
  std::size_t link;
  model::Capsule capsule;  ///< in the link's frame
};

}  // namespace internal

namespace {

using Eigen::Vector3d;
using kinematics::Configuration;
using kinematics::Posture;
using kinematics::Robot;
using Part = internal::WatchedPart;

bool is_moved_by_a_joint(const Robot& robot, std::size_t link) {
  if (robot.links[link].joint.kind != kinematics::Joint::Kind::fixed) return true;
  return robot.links[link].parent && is_moved_by_a_joint(robot, *robot.links[link].parent);
}

model::Capsule in_world(const Part& part, const Posture& posture) {
  return {posture.link(part.link) * part.capsule.a, posture.link(part.link) * part.capsule.b,
          part.capsule.radius};
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

/// The first link of the rigid body, of links with fixed joints between them, that a link is part of.
std::size_t rigid_body_of(const Robot& robot, std::size_t link) {
  while (robot.links[link].joint.kind == kinematics::Joint::Kind::fixed && robot.links[link].parent)
    link = *robot.links[link].parent;
  return link;
}

bool are_one_or_joined(const Robot& robot, std::size_t link, std::size_t other) {
  const std::size_t one = rigid_body_of(robot, link), two = rigid_body_of(robot, other);
  const auto is_on = [&](std::size_t body, std::size_t carrier) {
    const auto& parent = robot.links[body].parent;
    return parent && rigid_body_of(robot, *parent) == carrier;
  };
  return one == two || is_on(one, two) || is_on(two, one);
}

bool overlap(const Part& p, const Part& q, const Posture& posture) {
  return distance_of_axes(in_world(p, posture), in_world(q, posture)) <= p.capsule.radius + q.capsule.radius;
}

/// All joints at 0, or at the limit nearest to it.
Configuration at_rest(const Robot& robot) {
  std::vector<double> positions;
  for (const auto& link : robot.links)
    if (link.joint.kind != kinematics::Joint::Kind::fixed)
      positions.push_back(std::max(link.joint.low, std::min(0.0, link.joint.high)));
  return Eigen::Map<Configuration>(positions.data(), std::ssize(positions));
}

/// The smallest distances, and of which links.
struct Nearest {
  double to_surface = std::numeric_limits<double>::infinity();
  double to_itself = std::numeric_limits<double>::infinity();
  std::size_t link = 0;
  std::array<std::size_t, 2> links{};
};

}  // namespace

struct LinkWatch::Inside {
  const Robot& robot;
  const TrueSurface& truth;
  double fineness;
  std::vector<internal::WatchedPart> parts;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;

  /// Takes account of one more configuration.
  void look(const Configuration& at, Nearest& nearest) const {
    const Posture posture(robot, at);
    std::vector<model::Capsule> capsules;
    for (const Part& part : parts) capsules.push_back(in_world(part, posture));
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const double distance = truth.distance_along(capsules[i].a, capsules[i].b) - capsules[i].radius;
      if (distance < nearest.to_surface) nearest.to_surface = distance, nearest.link = parts[i].link;
    }
    for (const auto& [i, j] : pairs) {
      const double distance =
          distance_of_axes(capsules[i], capsules[j]) - capsules[i].radius - capsules[j].radius;
      if (distance < nearest.to_itself)
        nearest.to_itself = distance, nearest.links = {parts[i].link, parts[j].link};
    }
  }

  /// A bound on how far any point of a part gets from where it was: a turn takes it by more than its ends are
  /// apart, by less than twice for turns up to half a circle.
  double farthest(const Configuration& from, const Configuration& to) const {
    const Posture one(robot, from), other(robot, to);
    double most = 0;
    for (const Part& part : parts) {
      const model::Capsule p = in_world(part, one), q = in_world(part, other);
      most = std::max({most, (p.a - q.a).norm(), (p.b - q.b).norm()});
    }
    return 2 * most;
  }
};

LinkWatch::LinkWatch(const Robot& robot, const TrueSurface& truth, double fineness,
                     const Configuration& first)
    : inside_(new Inside{robot, truth, fineness, {}, {}}) {
  auto& [unused, surface, fine, parts, pairs] = *inside_;
  for (std::size_t i = 0; i < robot.links.size(); ++i)
    if (is_moved_by_a_joint(robot, i))
      for (const model::Capsule& capsule : robot.links[i].body) parts.push_back({i, capsule});
  const Posture beginning(robot, first), rest(robot, at_rest(robot));
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = i + 1; j < parts.size(); ++j)
      if (!are_one_or_joined(robot, parts[i].link, parts[j].link) &&
          !overlap(parts[i], parts[j], beginning) && !overlap(parts[i], parts[j], rest))
        pairs.emplace_back(i, j);
}

LinkWatch::~LinkWatch() = default;

LinkClearance LinkWatch::measure(const Configuration& from, const Configuration& to) const {
  const int pieces = 1 + static_cast<int>(std::ceil(inside_->farthest(from, to) / inside_->fineness));
  Nearest nearest;
  for (int k = 0; k <= pieces; ++k)
    inside_->look(from + (to - from) * (static_cast<double>(k) / pieces), nearest);
  LinkClearance result;
  result.to_surface = nearest.to_surface, result.worst_link = nearest.link;
  result.to_itself = nearest.to_itself, result.nearest_links = nearest.links;
  result.collisions = nearest.to_surface <= 0;
  result.self_collisions = nearest.to_itself <= 0;
  return result;
}

std::optional<LinkClearance> LinkWatch::touched(const Configuration& from, const Configuration& to) const {
  Nearest nearest;
  inside_->look(from, nearest);
  const double farthest = inside_->farthest(from, to);
  // Two links can come towards each other, each by as much.
  if (nearest.to_surface > farthest && nearest.to_itself > 2 * farthest) return std::nullopt;
  LinkClearance result = measure(from, to);
  if (result.collisions + result.self_collisions == 0) return std::nullopt;
  return result;
}

LinkClearance link_clearance(const Robot& robot, std::span<const Configuration> way, const TrueSurface& truth,
                             double fineness) {
  LinkClearance result;
  if (way.empty()) return result;
  const LinkWatch watch(robot, truth, fineness, way.front());
  const std::size_t steps = std::max<std::size_t>(1, way.size() - 1);  // of one configuration, it alone
  for (std::size_t i = 0; i < steps; ++i) {
    const LinkClearance step = watch.measure(way[i], way[std::min(i + 1, way.size() - 1)]);
    if (step.to_surface < result.to_surface)
      result.to_surface = step.to_surface, result.worst = i, result.worst_link = step.worst_link;
    if (step.to_itself < result.to_itself)
      result.to_itself = step.to_itself, result.nearest_links = step.nearest_links;
    result.collisions += step.collisions;
    result.self_collisions += step.self_collisions;
  }
  return result;
}

}  // namespace limpet::evaluation
