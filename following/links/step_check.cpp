// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/following/links/step_check.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace limpet::following {
namespace {

using Eigen::Vector3d;
using kinematics::Configuration;
using kinematics::Posture;
using model::Capsule;

/// An upper bound on how far any point of the part moves on the whole way. The distance of a point from a
/// joint's axis grows on the way by no more than the point and the axis move, which the second term allows
/// for twice over.
double motion_bound(const kinematics::BodyPart& part, const Posture& posture, const Configuration& changes) {
  const Eigen::VectorXd reach = kinematics::reach_of_joints(part, posture), by = changes.cwiseAbs();
  const double first = reach.dot(by);
  double revolute = 0;
  kinematics::for_each_moving_joint(posture.robot(), [&](Eigen::Index k, const kinematics::Joint& joint) {
    if (joint.kind == kinematics::Joint::Kind::revolute && reach[k] > 0) revolute += by[k];
  });
  return first + 2 * revolute * first;
}

/// Is a distance that changes by no more than `bound` between two places never below `least` in between?
/// `at(t)`: the distance at a fraction of the way.
bool stays_above(double least, double slack, double bound, double from, double to, double d_from, double d_to,
                 const std::function<double(double)>& at) {
  if (std::min(d_from, d_to) < least) return false;
  const double way = bound * (to - from);
  if ((d_from + d_to - way) / 2 >= least - slack) return true;
  const double middle = (from + to) / 2, d_middle = at(middle);
  return stays_above(least, slack, bound, from, middle, d_from, d_middle, at) &&
         stays_above(least, slack, bound, middle, to, d_middle, d_to, at);
}

}  // namespace

bool keeps_clear(const Posture& posture, const Configuration& changes, const Obstacles& obstacles,
                 std::span<const GuardedPart> parts) {
  for (const GuardedPart& guarded : parts) {
    const double bound = motion_bound(guarded.part, posture, changes), slack = 0.01 * guarded.least;
    const double reach = guarded.least + 2 * bound + slack;
    const auto at = [&](double t) {
      const Posture there(posture.robot(), posture.configuration() + t * changes);
      return obstacles.distance(kinematics::in_world(guarded.part, there), reach);
    };
    const double start = at(0);
    if (start >= guarded.least + bound) continue;  // nothing is near enough
    const double end = at(1);
    if (start < guarded.least && end <= start) return false;
    if (!stays_above(std::min(guarded.least, start), slack, bound, 0, 1, start, end, at)) return false;
  }
  return true;
}

bool keeps_apart(const Posture& posture, const Configuration& changes,
                 std::span<const kinematics::BodyPart> parts, std::span<const kinematics::PairOfParts> pairs,
                 double least) {
  for (const kinematics::PairOfParts& pair : pairs) {
    const auto& p = parts[pair.first];
    const auto& q = parts[pair.second];
    const double bound = motion_bound(p, posture, changes) + motion_bound(q, posture, changes);
    const auto at = [&](double t) {
      const Posture there(posture.robot(), posture.configuration() + t * changes);
      return kinematics::distance_between(kinematics::in_world(p, there), kinematics::in_world(q, there));
    };
    const double start = at(0), slack = 0.01 * least;
    if (start >= least + bound) continue;
    const double end = at(1);
    if (start < least && end <= start) return false;
    if (!stays_above(std::min(least, start), slack, bound, 0, 1, start, end, at)) return false;
  }
  return true;
}

}  // namespace limpet::following
