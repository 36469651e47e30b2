// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/following/links/link_guard.hpp>

namespace limpet::following {

using kinematics::Configuration;
using kinematics::Posture;

namespace {

/// The control point as a part without extent.
GuardedPart control_part(const kinematics::Robot& robot, double least) {
  const auto& [link, position] = robot.control_point;
  return {{link, {position, position, 0}}, least};
}

bool is_within_limits(const Posture& posture) {
  const Configuration& at = posture.configuration();
  return at == kinematics::within_limits(posture.robot(), at);
}

}  // namespace

LinkGuard::LinkGuard(const kinematics::Robot& robot, const LinkParameters& p)
    : robot_(&robot), own_distance_(p.own_distance), body_(kinematics::moving_body(robot, p.spared)) {
  for (const kinematics::BodyPart& part : body_) guarded_.push_back({part, p.least_distance});
  guarded_.push_back(control_part(robot, p.control_clearance));
  pairs_ = kinematics::pairs_to_keep_apart(robot, body_);
}

bool LinkGuard::is_clear(const Posture& posture, const Obstacles& obstacles) const {
  if (!is_within_limits(posture)) return false;
  for (const auto& [i, j] : pairs_)
    if (kinematics::distance_between(in_world(body_[i], posture), in_world(body_[j], posture)) <
        own_distance_)
      return false;
  for (const auto& [part, least] : guarded_)
    if (obstacles.distance(kinematics::in_world(part, posture), least) < least) return false;
  return true;
}

bool LinkGuard::is_no_worse(const Posture& here, const Posture& there, const Obstacles& obstacles) const {
  for (const auto& [i, j] : pairs_) {
    const auto apart = [&](const Posture& at) {
      return kinematics::distance_between(in_world(body_[i], at), in_world(body_[j], at));
    };
    if (const double now = apart(here); now < own_distance_ && now <= apart(there)) return false;
  }
  for (const auto& [part, least] : guarded_) {
    const auto away = [&](const Posture& at) {
      return obstacles.distance(kinematics::in_world(part, at), least);
    };
    if (const double now = away(here); now < least && now <= away(there)) return false;
  }
  return is_within_limits(here);
}

bool LinkGuard::keeps(const Posture& posture, const Configuration& changes,
                      const Obstacles& obstacles) const {
  return keeps_apart(posture, changes, body_, pairs_, own_distance_) &&
         keeps_clear(posture, changes, obstacles, guarded_);
}

Configuration LinkGuard::longest(const Posture& posture, Configuration changes,
                                 const Obstacles& obstacles) const {
  constexpr int kHalvings = 6;
  for (int i = 0; i <= kHalvings; ++i, changes /= 2)
    if (keeps(posture, changes, obstacles)) return changes;
  return Configuration::Zero(changes.size());
}

bool LinkGuard::connects(const Configuration& from, const Configuration& to,
                         const Obstacles& obstacles) const {
  constexpr double kPiece = 0.15;  // the bounds on motions are loose beyond
  const Configuration way = to - from;
  const int pieces = 1 + static_cast<int>(way.norm() / kPiece);
  // The middle first: where something is in the way, it seldom is next to an end.
  if (pieces > 1 && !is_clear(Posture(*robot_, from + way / 2), obstacles)) return false;
  for (int i = 0; i < pieces; ++i) {
    const Posture posture(*robot_, from + way * (static_cast<double>(i) / pieces));
    if (!keeps(posture, way / pieces, obstacles)) return false;
  }
  return true;
}

}  // namespace limpet::following
