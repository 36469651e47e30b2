// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/following/links/step_programme.hpp>

#include <algorithm>
#include <limits>

namespace limpet::following {
namespace {

using Eigen::Vector3d;
using kinematics::Configuration;
using kinematics::Posture;
using kinematics::Proximity;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
/// How much of the room between a link and an obstacle, or of that to a joint's limit, one step may take.
constexpr double kDamping = 0.7;
/// Weights against |J Δq − v|²: of |Δq|², and of the way up the objective of (4), both per square of a lever
/// of one length.
constexpr double kEffort = 1e-4, kGradient = 0.02;

}  // namespace

StepProgramme::StepProgramme(const LinkGuard& guard, const LinkParameters& parameters)
    : guard_(guard), parameters_(parameters) {}

Configuration StepProgramme::changes(const Posture& posture, const Task& task, const Obstacles& obstacles,
                                     std::span<const std::size_t> seeing) {
  obstacles.nearest_of_links(posture, guard_.body(), parameters_.objective.influence, near_);
  Eigen::VectorXd z = kinematics::reconfiguration(posture, near_, parameters_.objective);
  if (!seeing.empty())
    z += kinematics::reconfiguration(posture, posture.robot().switches, seeing,
                                     parameters_.objective.exponent);
  aim(posture, task, z);
  bound(posture);
  obstacles.near(posture, guard_.body(), parameters_.objective.influence, near_);
  hold_.clear();
  problem_.inequality_matrix.resize(
      static_cast<Eigen::Index>(near_.size() + guard_.pairs().size() + seeing.size()),
      posture.configuration().size());
  problem_.inequality_vector.resize(problem_.inequality_matrix.rows());
  keep_off(posture);
  keep_apart(posture);
  keep_from_fields(posture, seeing);
  const auto rows = static_cast<Eigen::Index>(hold_.size());
  problem_.inequality_matrix.conservativeResize(rows, Eigen::NoChange);
  problem_.inequality_vector.conservativeResize(rows);
  return kinematics::limited(posture, solve());
}

/// The cost: move the point so, and by the way down the objective's gradient.
void StepProgramme::aim(const Posture& posture, const Task& task, const Eigen::VectorXd& z) {
  const auto& [motion, jacobian] = task;
  const double lever = kinematics::largest_lever(posture);
  problem_.hessian = jacobian.transpose() * jacobian;
  problem_.hessian.diagonal().array() += kEffort * lever * lever;
  problem_.gradient = -jacobian.transpose() * motion - kGradient * z;
}

/// No joint beyond its limits, nor faster than the ceiling of its kind.
void StepProgramme::bound(const Posture& posture) {
  const kinematics::Robot& robot = posture.robot();
  problem_.low = problem_.high = Eigen::VectorXd::Zero(posture.configuration().size());
  kinematics::for_each_moving_joint(robot, [&](Eigen::Index k, const kinematics::Joint& joint) {
    const double ceiling = robot.ceilings.of(joint), at = posture.configuration()[k];
    problem_.low[k] = std::max(-ceiling, std::min(0.0, kDamping * (joint.low - at)));
    problem_.high[k] = std::min(ceiling, std::max(0.0, kDamping * (joint.high - at)));
  });
}

void StepProgramme::keep_off(const Posture& posture) {
  for (const Proximity& p : near_)
    add_row(p.away.transpose() * posture.jacobian(p.link, p.on_link), p.distance, parameters_.least_distance);
}

void StepProgramme::keep_apart(const Posture& posture) {
  const auto& body = guard_.body();
  for (const auto& [first, second] : guard_.pairs()) {
    const kinematics::NearestOfCapsules nearest =
        kinematics::nearest_points(in_world(body[first], posture), in_world(body[second], posture));
    if (nearest.distance > parameters_.objective.influence) continue;
    add_row(nearest.away.transpose() * (posture.jacobian(body[first].link, nearest.on_first) -
                                        posture.jacobian(body[second].link, nearest.on_second)),
            nearest.distance, parameters_.own_distance);
  }
}

/// How much room there is a switch does not tell: none of it may be taken.
void StepProgramme::keep_from_fields(const Posture& posture, std::span<const std::size_t> seeing) {
  for (const std::size_t i : seeing) {
    const Posture::Switch s = posture.proximity_switch(i);
    add_row(-s.axis.transpose() * posture.jacobian(posture.robot().switches[i].link, s.position), 0, 0);
  }
}

/// What `away` · Δq leads away from may be neared by a part of the room there is; what is too near is to be
/// left, or at least, by a little more than the step's second order takes, not neared.
void StepProgramme::add_row(const Eigen::RowVectorXd& away, double distance, double least) {
  constexpr double kNothing = 1e-9;  // of a unit of joint motion: no joint has a say
  constexpr double kHold = 0.02;     // of the distance to be kept
  if (away.norm() < kNothing) return;
  const auto row = static_cast<Eigen::Index>(hold_.size());
  problem_.inequality_matrix.row(row) = away;
  problem_.inequality_vector[row] = -kDamping * (distance - least);
  hold_.push_back(distance < least ? kHold * least : kInfinite);
}

Configuration StepProgramme::solve() {
  using Status = kinematics::QuadraticSolution::Status;
  const auto* solution = &solver_.solve(problem_);
  for (const bool hold : {true, false}) {
    if (solution->status != Status::infeasible) break;
    for (std::size_t i = 0; i < hold_.size(); ++i) {
      double& least = problem_.inequality_vector[static_cast<Eigen::Index>(i)];
      least = std::min(least, hold ? hold_[i] : 0);
    }
    solution = &solver_.solve(problem_);
  }
  if (solution->status != Status::optimal) return Configuration::Zero(problem_.gradient.size());
  return solution->x;
}

}  // namespace limpet::following
