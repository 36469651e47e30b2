// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/following/links/goal_postures.hpp>
#include <limpet/following/links/halton_internal.hpp>

#include <Eigen/Cholesky>
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

/// From here, the control point led to the place; none: it does not get there within the limits.
std::optional<Configuration> led_to(const Robot& robot, Configuration at, const Vector3d& place,
                                    double precision) {
  constexpr int kSteps = 40;
  constexpr double kDamping = 1e-3, kLongest = 0.4;
  for (int i = 0; i < kSteps; ++i) {
    const Posture posture(robot, at);
    const Vector3d off = place - posture.control_point();
    if (off.norm() < precision) return at;
    const Eigen::Matrix3Xd jacobian = posture.jacobian();
    const Eigen::Matrix3d square =
        jacobian * jacobian.transpose() + kDamping * jacobian.squaredNorm() * Eigen::Matrix3d::Identity();
    Configuration step = jacobian.transpose() * square.ldlt().solve(off);
    if (step.norm() > kLongest) step *= kLongest / step.norm();
    at = kinematics::within_limits(robot, at + step);
  }
  return std::nullopt;
}

/// The nodes whose control points are nearest to the place, no two of one kind of posture.
std::vector<Configuration> seeds_of(const Roadmap& roadmap, const Vector3d& place, std::size_t most) {
  constexpr double kOther = 8;  // steps from each other
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < roadmap.nodes().size(); ++i)
    order.emplace_back((roadmap.nodes()[i].place - place).norm(), i);
  std::sort(order.begin(), order.end());
  std::vector<Configuration> seeds;
  for (const auto& [distance, node] : order) {
    if (seeds.size() == most) break;
    const Configuration& at = roadmap.nodes()[node].at;
    if (std::all_of(seeds.begin(), seeds.end(),
                    [&](const Configuration& other) { return roadmap.steps(other, at) > kOther; }))
      seeds.push_back(at);
  }
  return seeds;
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

bool lies_in_sensed(const LinkMotion& links, const Posture& posture) {
  const auto& body = links.guard().body();
  return std::all_of(body.begin(), body.end(), [&](const kinematics::BodyPart& part) {
    return links.sensed().holds(kinematics::in_world(part, posture));
  });
}

std::vector<Configuration> goal_postures(const LinkMotion& links, const Roadmap& roadmap,
                                         const Vector3d& place) {
  constexpr std::size_t kSeeds = 24, kSpread = 120, kMost = 6;
  constexpr double kPrecision = 0.1, kSame = 2;  // λ; steps
  const Robot& robot = links.guard().robot();
  std::vector<Configuration> seeds = seeds_of(roadmap, place, kSeeds);
  const Eigen::Index joints = roadmap.nodes().front().at.size();
  for (int i = 1; i <= static_cast<int>(kSpread); ++i)
    seeds.push_back(spread_over(robot, internal::halton(i, joints)));

  using Goal = std::tuple<bool, double, std::size_t>;  // unsensed, steps from the roadmap, index
  std::vector<Configuration> found;
  std::vector<Goal> order;
  for (const Configuration& seed : seeds) {
    const auto at = led_to(robot, seed, place, kPrecision * links.parameters().resolution);
    if (!at) continue;
    const Posture posture(robot, *at);
    if (!links.guard().is_clear(posture, links.obstacles())) continue;
    if (std::any_of(found.begin(), found.end(),
                    [&](const Configuration& other) { return roadmap.steps(other, *at) < kSame; }))
      continue;
    const std::size_t near = roadmap.nearest(*at, 1).front();
    order.emplace_back(!lies_in_sensed(links, posture), roadmap.steps(roadmap.nodes()[near].at, *at),
                       found.size());
    found.push_back(*at);
  }
  std::sort(order.begin(), order.end());
  std::vector<Configuration> goals;
  for (std::size_t i = 0; i < std::min(kMost, order.size()); ++i)
    goals.push_back(found[std::get<2>(order[i])]);
  return goals;
}

}  // namespace limpet::following
