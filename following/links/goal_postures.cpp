// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/following/links/goal_postures.hpp>
#include <limpet/following/links/halton_internal.hpp>
#include <limpet/following/links/inverse_kinematics.hpp>

#include <algorithm>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

namespace limpet::following {
namespace {

using Eigen::Vector3d;
using kinematics::Configuration;
using kinematics::Posture;
using kinematics::Robot;

constexpr double kPrecision = 0.1;  // λ

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

/// The nodes whose control points are nearest to the place, no two of one kind of posture.
std::vector<Configuration> nodes_near(const Roadmap& roadmap, const Vector3d& place, std::size_t most) {
  constexpr double kOther = 8;  // steps from each other
  std::vector<Configuration> seeds;
  for (const std::size_t node : by_distance(roadmap, place)) {
    if (seeds.size() == most) break;
    const Configuration& at = roadmap.nodes()[node].at;
    if (std::all_of(seeds.begin(), seeds.end(),
                    [&](const Configuration& other) { return roadmap.steps(other, at) > kOther; }))
      seeds.push_back(at);
  }
  return seeds;
}

std::vector<Configuration> seeds_of(const Robot& robot, const Roadmap& roadmap, const Vector3d& place) {
  constexpr std::size_t kNodes = 24, kSpread = 120;
  std::vector<Configuration> seeds = nodes_near(roadmap, place, kNodes);
  const Eigen::Index joints = roadmap.nodes().front().at.size();
  for (int i = 1; i <= static_cast<int>(kSpread); ++i)
    seeds.push_back(spread_over(robot, internal::halton(i, joints)));
  return seeds;
}

/// Clear configurations, no two of them the same.
class Goals {
 public:
  Goals(const LinkMotion& links, const Roadmap& roadmap) : links_(links), roadmap_(roadmap) {}

  bool is_new(const Configuration& at) const {
    constexpr double kSame = 2;  // steps
    return std::none_of(found_.begin(), found_.end(),
                        [&](const Configuration& other) { return roadmap_.steps(other, at) < kSame; });
  }

  void add(const Posture& posture) {
    const Configuration& at = posture.configuration();
    if (!links_.guard().is_clear(posture, links_.obstacles()) || !is_new(at)) return;
    const std::size_t near = roadmap_.nearest(at, 1).front();
    order_.emplace_back(!links_.is_sensed(posture), roadmap_.steps(roadmap_.nodes()[near].at, at),
                        found_.size());
    found_.push_back(at);
  }

  bool empty() const { return found_.empty(); }

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
  using Rank = std::tuple<bool, double, std::size_t>;  // unsensed, steps from the roadmap, index
  const LinkMotion& links_;
  const Roadmap& roadmap_;
  std::vector<Configuration> found_;
  std::vector<Rank> order_;
};

/// Looking at a place with a robot's sensors.
class Look {
 public:
  Look(const LinkMotion& links, const Suspicion& suspicion, Sight sight)
      : links_(links), suspicion_(suspicion), is_sure_(sight == Sight::sure) {}

  /// The point on the sensor's axis that is to be brought to the place: the nearest of those at which
  /// something would be met for certain, and from which the sensor is not too near to it.
  Vector3d point_of(const Posture::Sensor& sensor) const {
    constexpr double kSurelyBeyond = 0.7, kBeyond = 0.1;  // λ
    const LinkParameters& p = links_.parameters();
    const double beyond = (is_sure_ ? kSurelyBeyond : kBeyond) * p.resolution;
    const double nearest = p.control_clearance, farthest = sensor.range - beyond;
    const double along = (suspicion_.at - sensor.position).dot(sensor.axis);
    return sensor.position + std::clamp(along, std::min(nearest, farthest), farthest) * sensor.axis;
  }

  TaskIn task_of(std::size_t i) const {
    return [this, i](const Posture& posture) {
      const Vector3d point = point_of(posture.sensor(i));
      return Task{suspicion_.at - point, posture.jacobian(posture.robot().sensors[i].link, point)};
    };
  }

  /// How far the sensor looks past the place; more for one that looks from behind or along the surface.
  double miss(const Posture& posture, std::size_t i) const {
    constexpr double kFrontal = 0.5;
    const auto sensor = posture.sensor(i);
    const double turned = std::max(0.0, kFrontal + sensor.axis.dot(suspicion_.normal));
    return (suspicion_.at - point_of(sensor)).norm() + turned * sensor.range;
  }

  bool sees(const Posture& posture, std::size_t i) const {
    constexpr double kSure = 0.26, kFaint = 0.1;  // cosines of 75° and 84°
    const auto sensor = posture.sensor(i);
    if (-sensor.axis.dot(suspicion_.normal) < (is_sure_ ? kSure : kFaint)) return false;
    const Vector3d way = suspicion_.at - sensor.position;
    const double free = way.norm() - links_.parameters().resolution / 2;
    return free <= 0 || !links_.obstacles().view().first_hit(sensor.position, way, free);
  }

 private:
  const LinkMotion& links_;
  const Suspicion& suspicion_;
  bool is_sure_;
};

/// A configuration to begin with, and the sensor that is to see.
struct Start {
  Configuration at;
  std::size_t sensor;
};

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
  for (int i = 1; i <= kSpread; ++i) from.push_back(spread_over(robot, internal::halton(i, joints)));
  return from;
}

/// Of these configurations those that look past the place by least, and with which sensor.
std::vector<Start> starts_of(const Look& look, const Robot& robot, const std::vector<Configuration>& from,
                             std::span<const std::size_t> sensors) {
  constexpr int kSensors = 2;
  constexpr std::size_t kMost = 240;
  std::vector<std::tuple<double, std::size_t, std::size_t>> order;  // miss, configuration, sensor
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Posture posture(robot, from[i]);
    const std::size_t first = order.size();
    for (const std::size_t sensor : sensors) order.emplace_back(look.miss(posture, sensor), i, sensor);
    std::sort(order.begin() + static_cast<std::ptrdiff_t>(first), order.end());
    order.resize(std::min(order.size(), first + kSensors));
  }
  std::sort(order.begin(), order.end());
  std::vector<Start> starts;
  for (std::size_t i = 0; i < std::min(kMost, order.size()); ++i)
    starts.push_back({from[std::get<1>(order[i])], std::get<2>(order[i])});
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

Configuration spread_over(const Robot& robot, const Eigen::VectorXd& unit) {
  Configuration at = unit;
  kinematics::for_each_moving_joint(robot, [&](Eigen::Index k, const kinematics::Joint& joint) {
    const double low = std::max(joint.low, -std::numbers::pi);
    at[k] = low + unit[k] * (std::min(joint.high, std::numbers::pi) - low);
  });
  return at;
}

std::vector<Configuration> goal_postures(const LinkMotion& links, const Roadmap& roadmap,
                                         const Vector3d& place) {
  const Robot& robot = links.guard().robot();
  const double precision = kPrecision * links.parameters().resolution;
  const auto task = [&](const Posture& posture) {
    return control_point_task(posture, place - posture.control_point());
  };
  Goals goals(links, roadmap);
  for (const Configuration& seed : seeds_of(robot, roadmap, place))
    if (const auto at = led_to(robot, seed, task, precision)) goals.add(Posture(robot, *at));
  return goals.best();
}

std::vector<Configuration> sighting_postures(LinkMotion& links, const Roadmap& roadmap,
                                             const Suspicion& suspicion, Sight sight,
                                             std::span<const std::size_t> sensors) {
  const Robot& robot = links.guard().robot();
  const double precision = kPrecision * links.parameters().resolution;
  const Look look(links, suspicion, sight);
  const std::vector<Start> starts =
      starts_of(look, robot, configurations_for(robot, roadmap, suspicion.at), sensors);
  Goals goals(links, roadmap);
  const auto take = [&](const Posture& posture, std::size_t sensor) {
    if (goals.is_new(posture.configuration()) && look.sees(posture, sensor)) goals.add(posture);
  };
  for (const Start& start : starts)
    if (const auto at = led_to(robot, start.at, look.task_of(start.sensor), precision))
      take(Posture(robot, *at), start.sensor);
  if (!goals.empty()) return goals.best();
  for (const Start& start : apart(starts, roadmap))
    if (const auto posture = links.led_clear(start.at, look.task_of(start.sensor)))
      take(*posture, start.sensor);
  return goals.best();
}

}  // namespace limpet::following
