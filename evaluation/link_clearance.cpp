// Copyright the limpet authors. GPL-3.0-or-later.
//
// Shares no code with what keeps links away in a run, but for where links are.
#include <limpet/evaluation/link_clearance.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace limpet::evaluation {
namespace {

using Eigen::Vector3d;
using kinematics::Configuration;
using kinematics::Posture;
using kinematics::Robot;

struct Part {
  std::size_t link;
  model::Capsule capsule;  ///< in the link's frame
};

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

class Measuring {
 public:
  Measuring(const Robot& robot, const TrueSurface& truth, const Configuration& first)
      : robot_(robot), truth_(truth) {
    for (std::size_t i = 0; i < robot.links.size(); ++i)
      if (is_moved_by_a_joint(robot, i))
        for (const model::Capsule& capsule : robot.links[i].body) parts_.push_back({i, capsule});
    const Posture posture(robot, first);
    for (std::size_t i = 0; i < parts_.size(); ++i)
      for (std::size_t j = i + 1; j < parts_.size(); ++j)
        if (are_apart(parts_[i], parts_[j], posture)) pairs_.emplace_back(i, j);
  }

  /// The smallest distances in a configuration.
  void look(const Configuration& at) {
    const Posture posture(robot_, at);
    std::vector<model::Capsule> capsules;
    for (const Part& part : parts_) capsules.push_back(in_world(part, posture));
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const double distance = truth_.distance_along(capsules[i].a, capsules[i].b) - capsules[i].radius;
      if (distance < surface_) surface_ = distance, link_ = parts_[i].link;
    }
    for (const auto& [i, j] : pairs_)
      itself_ = std::min(
          itself_, distance_of_axes(capsules[i], capsules[j]) - capsules[i].radius - capsules[j].radius);
  }
  void begin() { surface_ = itself_ = std::numeric_limits<double>::infinity(); }
  double surface() const { return surface_; }
  double itself() const { return itself_; }
  std::size_t link() const { return link_; }

  /// The farthest that an end of a part is from where it was.
  double farthest(const Configuration& from, const Configuration& to) const {
    const Posture one(robot_, from), other(robot_, to);
    double most = 0;
    for (const Part& part : parts_) {
      const model::Capsule p = in_world(part, one), q = in_world(part, other);
      most = std::max({most, (p.a - q.a).norm(), (p.b - q.b).norm()});
    }
    return most;
  }

 private:
  bool are_apart(const Part& p, const Part& q, const Posture& posture) const {
    const auto &one = robot_.links[p.link], &other = robot_.links[q.link];
    if (p.link == q.link || one.parent == q.link || other.parent == p.link) return false;
    return distance_of_axes(in_world(p, posture), in_world(q, posture)) > p.capsule.radius + q.capsule.radius;
  }

  const Robot& robot_;
  const TrueSurface& truth_;
  std::vector<Part> parts_;
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;
  double surface_ = 0, itself_ = 0;
  std::size_t link_ = 0;
};

}  // namespace

LinkClearance link_clearance(const Robot& robot, std::span<const Configuration> way, const TrueSurface& truth,
                             double fineness) {
  LinkClearance result;
  if (way.empty()) return result;
  Measuring measuring(robot, truth, way.front());
  const std::size_t steps = std::max<std::size_t>(1, way.size() - 1);  // of one configuration, it alone
  for (std::size_t i = 0; i < steps; ++i) {
    const Configuration& from = way[i];
    const Configuration& to = way[std::min(i + 1, way.size() - 1)];
    // A turn takes a point by more than its ends are apart: by less than twice, for turns up to half a
    // circle.
    const int pieces = 1 + static_cast<int>(std::ceil(2 * measuring.farthest(from, to) / fineness));
    measuring.begin();
    for (int k = 0; k <= pieces; ++k) measuring.look(from + (to - from) * (static_cast<double>(k) / pieces));
    if (measuring.surface() < result.to_surface)
      result.to_surface = measuring.surface(), result.worst = i, result.worst_link = measuring.link();
    result.to_itself = std::min(result.to_itself, measuring.itself());
    result.collisions += measuring.surface() <= 0;
    result.self_collisions += measuring.itself() <= 0;
  }
  return result;
}

}  // namespace limpet::evaluation
