// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/following/links/link_motion.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <limpet/kinematics/quadratic_program.hpp>

namespace limpet::following {
namespace {

using Eigen::Vector3d;
using kinematics::Configuration;
using kinematics::Posture;
using kinematics::Proximity;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// The control point as a part without extent.
GuardedPart control_part(const kinematics::Robot& robot, double least) {
  const auto& [link, position] = robot.control_point;
  return {{link, {position, position, 0}}, least};
}

}  // namespace

LinkParameters usual_link_parameters(const Parameters& p, Redundancy redundancy) {
  LinkParameters links;
  links.redundancy = redundancy;
  links.objective.influence = p.sensing_range;
  // α = 7000 is of the thesis's lengths, links of 1 and a range of 0.2: (5) is a length times a lever.
  links.objective.gain = 7000;
  links.least_distance = 1.2 * p.resolution;
  links.own_distance = 0.2 * p.resolution;
  links.control_clearance = p.clearance();
  links.spared = p.follow_distance;
  return links;
}

/// The programme of one step, with its memory.
struct LinkMotion::Programme {
  /// How much of the room between a link and an obstacle one step may take.
  static constexpr double kDamping = 0.7;
  /// Weights against |J Δq − v|²: of |Δq|², and of the way up the objective of (4), both per square of a
  /// lever of one length.
  static constexpr double kEffort = 1e-4, kGradient = 0.02;

  kinematics::QuadraticProgram problem;
  kinematics::QuadraticSolver solver;
  std::vector<Proximity> near;

  /// The part of the cost: move the control point so, and by the way down the objective's gradient.
  void aim(const Posture& posture, const Vector3d& motion, const Eigen::VectorXd& z, double lever) {
    const Eigen::Matrix3Xd jacobian = posture.jacobian();
    const Eigen::Index n = jacobian.cols();
    problem.hessian = jacobian.transpose() * jacobian;
    problem.hessian.diagonal().array() += kEffort * lever * lever;
    problem.gradient = -jacobian.transpose() * motion - kGradient * z;
    problem.low = Eigen::VectorXd::Constant(n, -kInfinite), problem.high = -problem.low;
  }

  /// No joint beyond its limits, nor faster than the ceiling of its kind.
  void bound(const Posture& posture) {
    const kinematics::Robot& robot = posture.robot();
    Eigen::Index k = 0;
    for (const kinematics::Link& link : robot.links) {
      if (link.joint.kind == kinematics::Joint::Kind::fixed) continue;
      const double ceiling = link.joint.kind == kinematics::Joint::Kind::prismatic
                                 ? robot.ceilings.prismatic
                                 : robot.ceilings.revolute_rad;
      const double at = posture.configuration()[k];
      problem.low[k] = std::max(-ceiling, std::min(0.0, kDamping * (link.joint.low - at)));
      problem.high[k] = std::min(ceiling, std::max(0.0, kDamping * (link.joint.high - at)));
      ++k;
    }
  }

  void clear_rows(Eigen::Index n, std::size_t most) {
    problem.inequality_matrix.resize(static_cast<Eigen::Index>(most), n);
    problem.inequality_vector.resize(static_cast<Eigen::Index>(most));
    rows_ = 0;
  }
  /// What moves along `direction · way` may come nearer by a part of the room it has, which may be negative.
  void add_row(const Eigen::RowVectorXd& towards, double room) {
    constexpr double kNothing = 1e-9;  // of a unit of joint motion: no joint has a say
    if (towards.norm() < kNothing) return;
    problem.inequality_matrix.row(rows_) = towards;
    problem.inequality_vector[rows_++] = -kDamping * room;
  }
  void finish_rows() {
    problem.inequality_matrix.conservativeResize(rows_, Eigen::NoChange);
    problem.inequality_vector.conservativeResize(rows_);
  }

  /// Where all that is too near cannot be led away at once, none of it comes nearer: standing still does.
  Configuration solve() {
    const auto* solution = &solver.solve(problem);
    using Status = kinematics::QuadraticSolution::Status;
    if (solution->status == Status::infeasible) {
      problem.inequality_vector = problem.inequality_vector.cwiseMin(0.0);
      solution = &solver.solve(problem);
    }
    if (solution->status != Status::optimal) return Configuration::Zero(problem.gradient.size());
    return solution->x;
  }

 private:
  Eigen::Index rows_ = 0;
};

LinkMotion::LinkMotion(const kinematics::Robot& robot, const LinkParameters& p)
    : robot_(robot),
      parameters_(p),
      body_(kinematics::moving_body(robot, p.spared)),
      programme_(std::make_unique<Programme>()),
      last_clearance_(kInfinite) {
  for (const kinematics::BodyPart& part : body_) guarded_.push_back({part, p.least_distance});
  guarded_.push_back(control_part(robot, p.control_clearance));
  pairs_ = kinematics::pairs_to_keep_apart(robot, body_);
}

LinkMotion::~LinkMotion() = default;

Configuration LinkMotion::changes(const Observation& seen, const Vector3d& motion) {
  readings_.add(seen.readings);
  return parameters_.redundancy == Redundancy::thesis ? by_thesis(seen, motion) : by_programme(seen, motion);
}

Configuration LinkMotion::by_thesis(const Observation& seen, const Vector3d& motion) {
  const model::View view = seen.model.view();
  const double influence = parameters_.objective.influence;
  const Obstacles obstacles(view, readings_, body_, seen.posture, influence);
  std::vector<Proximity>& near = programme_->near;
  obstacles.nearest_of_links(seen.posture, body_, influence, near);
  last_clearance_ = kInfinite;
  for (const Proximity& p : near) last_clearance_ = std::min(last_clearance_, p.distance);
  const Eigen::VectorXd z = kinematics::reconfiguration(seen.posture, near, parameters_.objective);
  return kinematics::limited(
      seen.posture, kinematics::redundant_changes(seen.posture, motion, z, parameters_.objective.gain));
}

Configuration LinkMotion::by_programme(const Observation& seen, const Vector3d& motion) {
  const model::View view = seen.model.view();
  const Posture& posture = seen.posture;
  const double influence = parameters_.objective.influence;
  const Obstacles obstacles(view, readings_, body_, posture, influence);
  Programme& programme = *programme_;

  obstacles.nearest_of_links(posture, body_, influence, programme.near);
  const Eigen::VectorXd z = kinematics::reconfiguration(posture, programme.near, parameters_.objective);
  programme.aim(posture, motion, z, kinematics::largest_lever(posture));
  programme.bound(posture);

  obstacles.near(posture, body_, influence, programme.near);
  last_clearance_ = kInfinite;
  programme.clear_rows(posture.configuration().size(), programme.near.size() + pairs_.size());
  for (const Proximity& p : programme.near) {
    last_clearance_ = std::min(last_clearance_, p.distance);
    programme.add_row(p.away.transpose() * posture.jacobian(p.link, p.on_link),
                      p.distance - parameters_.least_distance);
  }
  for (const kinematics::PairOfParts& pair : pairs_) {
    const kinematics::NearestOfCapsules nearest = kinematics::nearest_points(
        in_world(body_[pair.first], posture), in_world(body_[pair.second], posture));
    if (nearest.distance > influence) continue;
    programme.add_row(
        nearest.away.transpose() * (posture.jacobian(body_[pair.first].link, nearest.on_first) -
                                    posture.jacobian(body_[pair.second].link, nearest.on_second)),
        nearest.distance - parameters_.own_distance);
  }
  programme.finish_rows();
  return longest_clear(seen, kinematics::limited(posture, programme.solve()), obstacles);
}

/// The longest of changes, changes/2, changes/4, … that is clear; none when none is.
Configuration LinkMotion::longest_clear(const Observation& seen, Configuration changes,
                                        const Obstacles& obstacles) const {
  constexpr int kHalvings = 6;
  for (int i = 0; i <= kHalvings; ++i, changes /= 2)
    if (keeps_clear(seen.posture, changes, obstacles, guarded_) &&
        keeps_apart(seen.posture, changes, body_, pairs_, parameters_.own_distance))
      return changes;
  return Configuration::Zero(changes.size());
}

}  // namespace limpet::following
