// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/following/links/halton_internal.hpp>
#include <limpet/following/links/link_motion.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace limpet::following {

using Eigen::Vector3d;
using kinematics::Configuration;
using kinematics::Posture;

namespace {

constexpr double kModelled = 0.2;  ///< λ: what is this near to a polygon is modelled

/// How far any end of a part is moved.
double longest_motion(std::span<const kinematics::BodyPart> body, const Posture& from, const Posture& to) {
  double longest = 0;
  for (const kinematics::BodyPart& part : body) {
    const model::Capsule before = kinematics::in_world(part, from), after = kinematics::in_world(part, to);
    longest = std::max({longest, (after.a - before.a).norm(), (after.b - before.b).norm()});
  }
  return longest;
}

double cell_of(const LinkParameters& p) { return p.objective.influence / 2; }

}  // namespace

LinkParameters usual_link_parameters(const Parameters& p, Redundancy redundancy) {
  LinkParameters links;
  links.redundancy = redundancy;
  links.objective.influence = p.sensing_range;
  // α = 7000 is of the thesis's lengths, links of 1 and a range of 0.2: (5) is a length times a lever.
  links.objective.gain = 7000;
  links.resolution = p.resolution;
  links.max_step = p.max_step;
  links.least_distance = 1.2 * p.resolution;
  links.reading_distance = 2 * p.resolution;
  links.own_distance = 0.2 * p.resolution;
  links.control_clearance = p.clearance();
  links.spared = p.follow_distance;
  return links;
}

LinkMotion::LinkMotion(const kinematics::Robot& robot, const LinkParameters& p)
    : robot_(robot),
      parameters_(p),
      watch_(robot.joint_count()),
      guard_(robot_, p),
      programme_(guard_, parameters_),
      readings_(kModelled * p.resolution),
      sensed_(cell_of(p)) {}

void LinkMotion::look(const Observation& seen) {
  const model::View view = seen.model.view();
  readings_.look(view, seen.readings);
  sensed_.add(seen, guard_.body(), parameters_.resolution);
  if (watch_.look(seen.posture.configuration())) hold_stuck_joints(seen.posture.configuration());
  posture_.emplace(robot_, seen.posture.configuration());
  seeing_.assign(seen.seeing.begin(), seen.seeing.end());
  unexplained_.clear();
  std::copy_if(seeing_.begin(), seeing_.end(), std::back_inserter(unexplained_), [&](std::size_t i) {
    const Posture::Switch s = posture_->proximity_switch(i);
    return !view.nearest(s.field_centre, s.range / 2, {.points = false});
  });
  obstacles_.emplace(view, readings_.positions(), parameters_.reading_distance - parameters_.least_distance);
  clearance_ = obstacles_->clearance(*posture_, guard_.body(), parameters_.objective.influence);
}

/// Its encoder may say a little else each time.
void LinkMotion::hold_stuck_joints(const Configuration& here) {
  constexpr double kPlay = 1e-3;  // of the ceiling's kind: radians or lengths
  const std::vector<std::size_t> stuck = watch_.stuck();
  kinematics::for_each_moving_joint(robot_, [&](Eigen::Index k, kinematics::Joint& joint) {
    if (!std::binary_search(stuck.begin(), stuck.end(), static_cast<std::size_t>(k))) return;
    joint.low = std::max(joint.low, here[k] - kPlay);
    joint.high = std::min(joint.high, here[k] + kPlay);
  });
}

Configuration LinkMotion::changes(const Vector3d& motion) {
  if (!is_checked()) return by_thesis(motion);
  const Configuration wanted =
      programme_.changes(*posture_, control_point_task(*posture_, motion), *obstacles_, unexplained_);
  Configuration changes = guard_.longest(*posture_, careful(wanted), *obstacles_);
  if (!changes.isZero() || guard_.is_clear(*posture_, *obstacles_)) return changes;
  return way_out();
}

/// z of (5), or of links that are covered with switches that of appendix B.
Eigen::VectorXd LinkMotion::reconfiguration_by_thesis() const {
  const auto& switches = guard_.robot().switches;
  if (!switches.empty())
    return kinematics::reconfiguration(*posture_, switches, seeing_, parameters_.objective.exponent);
  std::vector<kinematics::Proximity> near;
  obstacles_->nearest_of_links(*posture_, guard_.body(), parameters_.objective.influence, near);
  return kinematics::reconfiguration(*posture_, near, parameters_.objective);
}

Configuration LinkMotion::by_thesis(const Vector3d& motion) {
  const Eigen::VectorXd z = reconfiguration_by_thesis();
  return kinematics::limited(*posture_,
                             kinematics::redundant_changes(*posture_, motion, z, parameters_.objective.gain));
}

bool LinkMotion::is_sensed(const Posture& posture) const {
  const auto& body = guard_.body();
  return std::all_of(body.begin(), body.end(), [&](const kinematics::BodyPart& part) {
    return sensed_.holds(kinematics::in_world(part, posture));
  });
}

/// Into space that none has seen to be free steps are short, so that what is there is seen before links get
/// to it.
Configuration LinkMotion::careful(const Configuration& way) const {
  const double longest = parameters_.resolution;
  const Posture end(guard_.robot(), posture_->configuration() + way);
  if (is_sensed(end)) return way;
  const double length = longest_motion(guard_.body(), *posture_, end);
  return length > longest ? Configuration(way * (longest / length)) : way;
}

Configuration LinkMotion::towards(const Configuration& there) const {
  const Configuration way = kinematics::limited(*posture_, there - posture_->configuration());
  return guard_.longest(*posture_, careful(way), *obstacles_);
}

/// Where something is too near and the programme finds no motion away from all of it: of small motions every
/// which way, the clear one after which all is farthest.
Configuration LinkMotion::way_out() const {
  constexpr int kTries = 64;
  const Configuration& at = posture_->configuration();
  Configuration best = Configuration::Zero(at.size());
  double farthest = 0;
  for (int i = 1; i <= kTries; ++i) {
    const Configuration wanted = internal::halton(i, at.size()).array() * 2 - 1;
    const Configuration way = kinematics::limited(*posture_, wanted);
    const double distance = obstacles_->clearance(Posture(guard_.robot(), at + way), guard_.body(),
                                                  2 * parameters_.least_distance);
    if (distance > farthest && guard_.keeps(*posture_, way, *obstacles_)) best = way, farthest = distance;
  }
  return best;
}

std::optional<Posture> LinkMotion::reaching(const Vector3d& place) {
  return led(
      *posture_, [&](const Posture& at) { return control_point_task(at, place - at.control_point()); },
      unexplained_);
}

std::optional<Posture> LinkMotion::led_clear(const Configuration& from, const TaskIn& task) {
  return led(Posture(guard_.robot(), from), task, {});
}

std::optional<Posture> LinkMotion::led(Posture posture, const TaskIn& task,
                                       std::span<const std::size_t> seeing) {
  constexpr double kThere = 0.1;  // λ
  constexpr int kMoreSteps = 4;
  Task next = task(posture);
  double left = next.way.norm();
  int steps = kMoreSteps + static_cast<int>(std::ceil(left / parameters_.max_step));
  while (left > kThere * parameters_.resolution) {
    if (left > parameters_.max_step) next.way *= parameters_.max_step / left;
    const Configuration changes = programme_.changes(posture, next, *obstacles_, seeing);
    const Posture there(guard_.robot(), posture.configuration() + changes);
    if (!guard_.is_no_worse(there, posture, *obstacles_)) return std::nullopt;
    posture = there;
    const double length = next.way.norm();
    next = task(posture);
    const double left_then = next.way.norm();
    if (--steps < 0 || left_then > left - 0.2 * length) return std::nullopt;
    left = left_then;
  }
  return posture;
}

}  // namespace limpet::following
