// Copyright the limpet authors. GPL-3.0-or-later.
//
// Shares no code with what keeps links away in a run, but for where links are.
#include <limpet/evaluation/link_clearance.hpp>
#include <limpet/evaluation/moved_body_internal.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace limpet::evaluation {
namespace {

using kinematics::Configuration;
using kinematics::Posture;
using kinematics::Robot;

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
  MovedBody body;

  /// Takes account of one more configuration.
  void look(const Configuration& at, Nearest& nearest) const {
    const std::vector<model::Capsule> capsules = body.in_world(Posture(robot, at));
    const auto link = [&](std::size_t i) { return body.parts()[i].link; };
    for (std::size_t i = 0; i < capsules.size(); ++i) {
      const double distance = truth.distance_along(capsules[i].a, capsules[i].b) - capsules[i].radius;
      if (distance < nearest.to_surface) nearest.to_surface = distance, nearest.link = link(i);
    }
    for (const auto& [i, j] : body.pairs())
      if (const double gap = gap_between(capsules[i], capsules[j]); gap < nearest.to_itself)
        nearest.to_itself = gap, nearest.links = {link(i), link(j)};
  }

  /// A bound on how far any point of a part gets from where it was: a turn takes it by more than its ends are
  /// apart, by less than twice for turns up to half a circle.
  double farthest(const Configuration& from, const Configuration& to) const {
    const auto one = body.in_world(Posture(robot, from)), other = body.in_world(Posture(robot, to));
    double most = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
      most = std::max({most, (one[i].a - other[i].a).norm(), (one[i].b - other[i].b).norm()});
    return 2 * most;
  }
};

LinkWatch::LinkWatch(const Robot& robot, const TrueSurface& truth, double fineness,
                     const Configuration& first)
    : inside_(new Inside{robot, truth, fineness, MovedBody(robot, first)}) {}

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
