// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/following/links/goal_postures.hpp>
#include <limpet/following/links/halton_internal.hpp>
#include <limpet/following/links/inverse_kinematics.hpp>

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "clear_goals_internal.hpp"

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;
using kinematics::Configuration;
using kinematics::Posture;
using kinematics::Robot;

/// Clear configurations, no two of them the same.
class Goals {
 public:
  Goals(const LinkMotion& links, const Roadmap& roadmap) : links_(links), roadmap_(roadmap) {}

  bool empty() const { return found_.empty(); }

  void add(const Posture& posture, const Wish& wish) {
    const Configuration& at = posture.configuration();
    if (!is_new(at) || (wish.holds && !wish.holds(posture))) return;
    if (!links_.guard().is_clear(posture, links_.obstacles())) return;
    const std::size_t near = roadmap_.nearest(at, 1).front();
    order_.emplace_back(!links_.is_sensed(posture), roadmap_.steps(roadmap_.nodes()[near].at, at),
                        found_.size());
    found_.push_back(at);
  }

  std::vector<Configuration> best() const {
    constexpr std::size_t kMost = 4;
    auto order = order_;
    std::sort(order.begin(), order.end());
    std::vector<Configuration> goals;
    for (std::size_t i = 0; i < std::min(kMost, order.size()); ++i)
      goals.push_back(found_[std::get<2>(order[i])]);
    return goals;
  }

 private:
  bool is_new(const Configuration& at) const {
    constexpr double kSame = 2;  // steps
    return std::none_of(found_.begin(), found_.end(),
                        [&](const Configuration& other) { return roadmap_.steps(other, at) < kSame; });
  }

  using Rank = std::tuple<bool, double, std::size_t>;  // unsensed, steps from the roadmap, index
  const LinkMotion& links_;
  const Roadmap& roadmap_;
  std::vector<Configuration> found_;
  std::vector<Rank> order_;
};

/// The nodes of the roadmap, that whose control point is nearest to the place first.
std::vector<std::size_t> by_distance(const Roadmap& roadmap, const Vector3d& place) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < roadmap.nodes().size(); ++i)
    order.emplace_back((roadmap.nodes()[i].place - place).squaredNorm(), i);
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> nodes;
  for (const auto& [distance2, node] : order) nodes.push_back(node);
  return nodes;
}

/// Nodes of the roadmap whose control points are nearest to the place, some of all others, and configurations
/// spread over the joints' ranges.
std::vector<Configuration> configurations_for(const Robot& robot, const Roadmap& roadmap,
                                              const Vector3d& place) {
  constexpr std::size_t kNear = 200, kFar = 200;
  constexpr int kSpread = 400;
  const std::vector<std::size_t> order = by_distance(roadmap, place);
  const std::size_t every = 1 + order.size() / kFar;
  std::vector<Configuration> from;
  for (std::size_t i = 0; i < order.size(); ++i)
    if (i < kNear || i % every == 0) from.push_back(roadmap.nodes()[order[i]].at);
  const Eigen::Index joints = from.front().size();
  for (int i = 1; i <= kSpread; ++i) from.push_back(spread_over(robot, halton(i, joints)));
  return from;
}

/// A configuration to begin with, and what it is to be led to.
struct Start {
  Configuration at;
  const Wish* wish;
};

/// Of these configurations, those that miss a wish by least, and of each the wishes.
std::vector<Start> starts_of(const Robot& robot, const std::vector<Configuration>& from,
                             const std::vector<Wish>& wishes) {
  constexpr std::size_t kWishes = 2, kMost = 240;
  std::vector<std::tuple<double, std::size_t, std::size_t>> order;  // miss, configuration, wish
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Posture posture(robot, from[i]);
    const std::size_t first = order.size();
    for (std::size_t w = 0; w < wishes.size(); ++w) order.emplace_back(wishes[w].miss(posture), i, w);
    std::sort(order.begin() + static_cast<std::ptrdiff_t>(first), order.end());
    order.resize(std::min(order.size(), first + kWishes));
  }
  std::sort(order.begin(), order.end());
  if (order.size() > kMost) order.resize(kMost);
  std::vector<Start> starts;
  for (const auto& [miss, configuration, wish] : order)
    starts.push_back({from[configuration], &wishes[wish]});
  return starts;
}

/// The first ones, no two of one kind of posture.
std::vector<Start> apart(const std::vector<Start>& starts, const Roadmap& roadmap) {
  constexpr std::size_t kMost = 16;
  constexpr double kOther = 3;  // steps from each other
  std::vector<Start> chosen;
  for (const Start& start : starts) {
    if (chosen.size() == kMost) break;
    if (std::all_of(chosen.begin(), chosen.end(),
                    [&](const Start& other) { return roadmap.steps(other.at, start.at) > kOther; }))
      chosen.push_back(start);
  }
  return chosen;
}

}  // namespace

std::vector<Configuration> clear_goals(LinkMotion& links, const Roadmap& roadmap, const Vector3d& place,
                                       const std::vector<Wish>& wishes) {
  constexpr double kPrecision = 0.1;  // λ
  const Robot& robot = links.guard().robot();
  const double precision = kPrecision * links.parameters().resolution;
  const std::vector<Start> starts = starts_of(robot, configurations_for(robot, roadmap, place), wishes);
  Goals goals(links, roadmap);
  for (const Start& start : starts)
    if (const auto at = led_to(robot, start.at, start.wish->task, precision))
      goals.add(Posture(robot, *at), *start.wish);
  if (!goals.empty()) return goals.best();
  for (const Start& start : apart(starts, roadmap))
    if (const auto posture = links.led_clear(start.at, start.wish->task)) goals.add(*posture, *start.wish);
  return goals.best();
}

}  // namespace limpet::following::internal
