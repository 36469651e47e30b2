// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/following/follower.hpp>
#include <limpet/following/frontier/frontier_follower.hpp>
#include <limpet/following/thesis/thesis_follower.hpp>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace limpet::following {
namespace {

using Eigen::Vector3d;

Parameters sound(const Parameters& parameters) {
  require_sound(parameters);
  return parameters;
}

void require(bool good, const char* what) {
  if (!good) throw std::invalid_argument(what);
}

/// Where the changes of the joints bring the control point.
Vector3d displacement_by(const kinematics::Posture& posture, const kinematics::Configuration& changes) {
  const kinematics::Posture there(posture.robot(), posture.configuration() + changes);
  return there.control_point() - posture.control_point();
}

/// The motion of the control point that the robot can make in one step.
Vector3d within_ceilings(const kinematics::Posture& posture, const Vector3d& motion) {
  return posture.jacobian() * kinematics::actuator_changes(posture, motion);
}

}  // namespace

Parameters usual_parameters(double resolution) {
  Parameters p;
  p.resolution = resolution;
  p.follow_distance = p.max_step = 2 * resolution;
  p.stray_limit = p.sensing_range = 4 * resolution;
  return p;
}

void require_sound(const Parameters& p) {
  require(p.resolution > 0, "the resolution λ must be positive");
  require(p.follow_distance > p.resolution, "the follow distance δ must exceed the resolution λ");
  require(p.follow_distance < p.sensing_range, "the follow distance δ must be below the sensing range");
  require(p.max_step > 0 && p.max_step < p.sensing_range,
          "the step σ_max must be positive and below the sensing range");
  require(p.stray_limit > p.follow_distance, "the stray limit ρ must exceed the follow distance δ");
  require(p.progress_period >= 2, "the progress period τ must be 2 steps or more");
}

std::string_view name_of(Mode mode) {
  constexpr std::string_view kNames[] = {"none",         "current surface", "current segment",
                                         "current edge", "point",           "gap",
                                         "extend",       "travel",          "reposition"};
  return kNames[static_cast<std::size_t>(mode)];
}

std::string_view name_of(End end) {
  constexpr std::string_view kNames[] = {"", "complete", "no surface", "stopped"};
  return kNames[static_cast<std::size_t>(end)];
}

std::unique_ptr<Follower> make_follower(Strategy strategy, const Parameters& parameters,
                                        std::unique_ptr<LinkMotion> links) {
  return strategy == Strategy::thesis ? make_thesis_follower(parameters, std::move(links))
                                      : make_frontier_follower(parameters, std::move(links));
}

Follower::Follower(const Parameters& parameters, std::unique_ptr<LinkMotion> links)
    : parameters_(sound(parameters)), clearance_(parameters.clearance()), links_(std::move(links)) {}

/// Nothing that stands still stays too near while the robot keeps away from it.
bool Follower::is_too_near_for_long(const Observation& seen) {
  constexpr int kPatience = 60;  // sets
  const double least = clearance_.least() * (1 - 1e-6);
  const bool is_clear = clearance_.at(seen.model.view(), seen.posture.control_point(), least) >= least;
  too_near_ = is_clear ? 0 : too_near_ + 1;
  return too_near_ > kPatience;
}

Motion Follower::next(const Observation& seen) {
  clearance_.remember(seen.readings);
  if (links_) links_->look(seen);
  Motion motion = choose(seen);
  if (is_too_near_for_long(seen)) motion.end = End::stopped;
  if (motion.end == End::none)
    make(seen, motion);
  else
    motion = {Vector3d::Zero(), kinematics::Configuration::Zero(seen.posture.configuration().size()),
              motion.mode, motion.end};
  return motion;
}

/// Makes of what is wanted what can be done.
void Follower::make(const Observation& seen, Motion& motion) {
  if (motion.changes.size() == 0) {
    const double length = motion.displacement.norm();
    if (length > parameters_.max_step) motion.displacement *= parameters_.max_step / length;
    // A joint at its limit ends what the pseudo-inverse finds, and not what a programme does.
    if (!judge()) motion.displacement = within_ceilings(seen.posture, motion.displacement);
    motion.displacement =
        clearance_.shortened(seen.model.view(), seen.posture.control_point(), motion.displacement);
    motion.changes = links_ ? links_->changes(motion.displacement)
                            : kinematics::actuator_changes(seen.posture, motion.displacement);
  }
  if (!links_) return;
  links_->told(motion.changes);
  motion.displacement = displacement_by(seen.posture, motion.changes);
}

}  // namespace limpet::following
