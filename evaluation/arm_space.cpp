// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <cmath>
#include <limits>
#include <limpet/evaluation/arm_space_internal.hpp>
#include <limpet/evaluation/joint_levers_internal.hpp>
#include <numbers>
#include <utility>

namespace limpet::evaluation {
namespace {

using kinematics::Configuration;
using kinematics::Joint;
using kinematics::Posture;
using kinematics::Robot;

Eigen::VectorXd levers_of(const Robot& robot, const MovedPart& part) {
  return joint_levers(robot, part.link, part.capsule.a)
      .cwiseMax(joint_levers(robot, part.link, part.capsule.b));
}

/// Of two parts against each other: a joint that carries both does not count.
Eigen::VectorXd between(const Robot& robot, const MovedPart& one, const MovedPart& other) {
  const Eigen::VectorXd p = levers_of(robot, one), q = levers_of(robot, other);
  Eigen::VectorXd levers = p + q;
  for (std::size_t i = 0, joint = 0; i < robot.links.size(); ++i) {
    if (robot.links[i].joint.kind == Joint::Kind::fixed) continue;
    const auto carries = [&](std::size_t link) {
      for (std::optional<std::size_t> l = link; l; l = robot.links[*l].parent)
        if (*l == i) return true;
      return false;
    };
    if (carries(one.link) && carries(other.link)) levers[static_cast<Eigen::Index>(joint)] = 0;
    ++joint;
  }
  return levers;
}

/// What of a capsule's axis is outside a ball: the pieces before it and behind it.
std::vector<model::Capsule> outside(const model::Capsule& capsule, const Eigen::Vector3d& centre,
                                    double radius) {
  const Eigen::Vector3d along = capsule.b - capsule.a, off = centre - capsule.a;
  const double length = along.norm();
  if (length == 0) return off.norm() < radius ? std::vector<model::Capsule>{} : std::vector{capsule};
  const double foot = off.dot(along) / length, aside2 = off.squaredNorm() - foot * foot;
  const double half2 = radius * radius - aside2;
  if (half2 <= 0) return {capsule};
  const double enters = foot - std::sqrt(half2), leaves = foot + std::sqrt(half2);
  const auto at = [&](double t) { return Eigen::Vector3d(capsule.a + t / length * along); };
  std::vector<model::Capsule> pieces;
  if (enters > 0) pieces.push_back({capsule.a, at(std::min(enters, length)), capsule.radius});
  if (leaves < length) pieces.push_back({at(std::max(leaves, 0.0)), capsule.b, capsule.radius});
  return pieces;
}

/// Part of a straight way: what is within `half` of `middle`, and the guards that have yet to be proven
/// there.
struct Piece {
  double middle = 0.5, half = 0.5;
  std::vector<std::size_t> guards;
};

}  // namespace

ArmSpace::ArmSpace(const Robot& robot, const TrueSurface& truth, const Configuration& start,
                   const ArmClearances& clearances)
    : robot_(robot), truth_(truth), clearances_(clearances), body_(robot, start) {
  const kinematics::ControlPoint& point = robot.control_point;
  for (std::size_t i = 0; i < body_.parts().size(); ++i) {
    const MovedPart& part = body_.parts()[i];
    const bool has_spared = part.link == point.link && clearances.spared > 0;
    guards_.push_back({i, kSurface, has_spared ? clearances.own : clearances.links, levers_of(robot, part)});
    if (!has_spared) continue;
    for (const model::Capsule& piece : outside(part.capsule, point.position, clearances.spared))
      beyond_.push_back({part.link, piece});
  }
  guards_.push_back({body_.parts().size(), kSurface, clearances.control_point,
                     joint_levers(robot, point.link, point.position)});
  for (std::size_t i = 0; i < beyond_.size(); ++i)
    guards_.push_back(
        {body_.parts().size() + 1 + i, kSurface, clearances.links, levers_of(robot, beyond_[i])});
  for (const auto& [i, j] : body_.pairs())
    guards_.push_back({i, j, clearances.own, between(robot, body_.parts()[i], body_.parts()[j])});
  levers_ = Eigen::VectorXd::Zero(start.size());
  for (const Guard& guard : guards_)
    if (guard.other == kSurface) levers_ = levers_.cwiseMax(guard.levers);

  low_ = high_ = from_ = to_ = start;
  Eigen::Index k = 0;
  for (const kinematics::Link& link : robot.links) {
    const Joint& joint = link.joint;
    if (joint.kind == Joint::Kind::fixed) continue;
    const bool turns = joint.kind == Joint::Kind::revolute;
    const double middle = turns ? 0 : start[k], most = turns ? std::numbers::pi : clearances.slide;
    low_[k] = joint.low, high_[k] = joint.high;
    from_[k] = std::isfinite(joint.low) ? joint.low : std::min(middle, joint.high) - most;
    to_[k] = std::isfinite(joint.high) ? joint.high : std::max(middle, joint.low) + most;
    turns_endless_.push_back(turns && std::isinf(joint.low) && std::isinf(joint.high));
    ++k;
  }
}

std::vector<model::Capsule> ArmSpace::parts_at(const Configuration& at) const {
  const Posture posture(robot_, at);
  std::vector<model::Capsule> parts = body_.in_world(posture);
  parts.push_back({posture.control_point(), posture.control_point(), 0});
  for (const auto& [link, capsule] : beyond_) {
    const Eigen::Isometry3d& pose = posture.link(link);
    parts.push_back({pose * capsule.a, pose * capsule.b, capsule.radius});
  }
  return parts;
}

double ArmSpace::room(const Guard& guard, const std::vector<model::Capsule>& parts) const {
  const model::Capsule& part = parts[guard.part];
  const double distance = guard.other == kSurface ? truth_.distance_along(part.a, part.b) - part.radius
                                                  : gap_between(part, parts[guard.other]);
  return distance - guard.least;
}

bool ArmSpace::holds(const Configuration& at) const {
  if ((at.array() < low_.array()).any() || (at.array() > high_.array()).any()) return false;
  const std::vector<model::Capsule> parts = parts_at(at);
  return std::all_of(guards_.begin(), guards_.end(),
                     [&](const Guard& guard) { return room(guard, parts) >= 0; });
}

bool ArmSpace::joins(const Configuration& from, const Configuration& to) const {
  const Configuration way = to - from;
  std::vector<double> moved;  // by the whole way
  std::vector<Piece> open(1);
  for (std::size_t i = 0; i < guards_.size(); ++i) {
    moved.push_back(guards_[i].levers.dot(way.cwiseAbs()));
    open.front().guards.push_back(i);
  }
  for (std::size_t next = 0; next < open.size(); ++next) {
    const Piece piece = std::move(open[next]);
    const std::vector<model::Capsule> parts = parts_at(from + piece.middle * way);
    std::vector<std::size_t> left;
    for (const std::size_t i : piece.guards) {
      const double free = room(guards_[i], parts), needed = piece.half * moved[i];
      if (free < 0 || (free < needed && needed < clearances_.fineness / 2)) return false;
      if (free < needed) left.push_back(i);
    }
    if (left.empty()) continue;
    open.push_back({piece.middle - piece.half / 2, piece.half / 2, left});
    open.push_back({piece.middle + piece.half / 2, piece.half / 2, std::move(left)});
  }
  return true;
}

Configuration ArmSpace::near(const Configuration& from, Configuration to) const {
  constexpr double kTurn = 2 * std::numbers::pi;
  for (Eigen::Index k = 0; k < to.size(); ++k)
    if (turns_endless_[static_cast<std::size_t>(k)] != 0)
      to[k] -= kTurn * std::round((to[k] - from[k]) / kTurn);
  return to;
}

double ArmSpace::distance(const Configuration& from, const Configuration& to) const {
  return levers_.dot((near(from, to) - from).cwiseAbs());
}

Configuration ArmSpace::within_limits(const Configuration& at) const {
  return at.cwiseMax(low_).cwiseMin(high_);
}

Configuration ArmSpace::random(survey::Random& random) const {
  Configuration at(low_.size());
  for (Eigen::Index k = 0; k < at.size(); ++k) at[k] = random.uniform(from_[k], to_[k]);
  return at;
}

}  // namespace limpet::evaluation
