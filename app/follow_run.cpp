// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/follow_run.hpp>

#include <algorithm>
#include <chrono>
#include <limpet/app/arguments.hpp>
#include <limpet/app/interrupt.hpp>
#include <optional>
#include <stdexcept>

namespace limpet::app {
namespace {

using Clock = std::chrono::steady_clock;

double microseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

model::Model begin(const FollowSetup& setup) {
  try {
    model::Model model(setup.model);
    model.add_initial(setup.world.initial);
    return model;
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

std::unique_ptr<following::LinkMotion> links_of(const FollowSetup& setup) {
  if (!setup.links) return nullptr;
  return std::make_unique<following::LinkMotion>(setup.robot, *setup.links);
}

}  // namespace

FollowRun::FollowRun(const FollowSetup& setup)
    : setup_(setup),
      model_(begin(setup)),
      follower_(following::make_follower(setup.strategy, setup.following, links_of(setup))),
      sensing_(*setup.world.world, setup.errors),
      watch_(setup.following.resolution, setup.robot.sensors.size()) {
  if (setup.end_at_collision && setup.world.truth)
    collisions_.emplace(setup.robot, *setup.world.truth, setup.links.has_value(),
                        setup.following.resolution / 5);
}

FollowOutcome FollowRun::go(const std::function<void(const FollowStep&)>& look) {
  FollowOutcome outcome;
  outcome.ended = go_on(outcome, look);
  outcome.marks = follower_->marks();
  outcome.stuck_sensors = watch_.stuck();
  if (const auto* links = follower_->links()) outcome.stuck_joints = links->stuck_joints();
  if (outcome.ended != "interrupted") finish(outcome);
  return outcome;
}

/// A run that is interrupted here, too, keeps the model of its last set, which a replay comes to as well.
void FollowRun::finish(FollowOutcome& outcome) {
  const std::string before = model_.state();
  model_.finish(interrupted);
  if (!interrupted()) return;
  model_ = model::Model::from_state(before);
  outcome.ended = "interrupted";
}

/// Without the readings of stuck sensors.
simulation::Sensed FollowRun::sense(const kinematics::Configuration& at) {
  const simulation::Sensed all = sensing_.sense(setup_.robot, at);
  const kinematics::Posture posture(setup_.robot, all.measured);
  simulation::Sensed good{all.measured, {}, {}, all.seeing};
  std::size_t next = 0;
  for (std::size_t sensor = 0; sensor < setup_.robot.sensors.size(); ++sensor) {
    const bool reads = next < all.sensors.size() && all.sensors[next] == sensor;
    const auto distance = reads ? std::optional(all.points[next].range) : std::nullopt;
    if (!watch_.is_stuck(sensor, posture.sensor(sensor).position, distance) && reads) {
      good.points.push_back(all.points[next]);
      good.sensors.push_back(sensor);
    }
    next += reads;
  }
  return good;
}

std::string FollowRun::go_on(FollowOutcome& outcome, const std::function<void(const FollowStep&)>& look) {
  kinematics::Configuration at = setup_.configuration;
  const auto begin = Clock::now();
  for (std::int64_t set = 0; set < setup_.max_sets; ++set) {
    if (interrupted()) return "interrupted";
    if (microseconds_since(begin) > 1e6 * setup_.max_seconds) return "max-seconds";
    const simulation::Sensed sensed = sense(at);
    outcome.path.push_back(kinematics::Posture(setup_.robot, at).control_point());
    if (setup_.links) outcome.way.push_back(at);
    outcome.readings += static_cast<std::int64_t>(sensed.points.size());

    auto start = Clock::now();
    const auto& changes = model_.update(sensed.points);
    outcome.model_us.push_back(microseconds_since(start));
    start = Clock::now();
    const kinematics::Posture posture(setup_.robot, sensed.measured);
    const following::Observation seen{model_, changes, posture, sensed.points, sensed.seeing};
    const following::Motion motion = follower_->next(seen);
    outcome.step_us.push_back(microseconds_since(start));
    if (const auto* links = follower_->links())
      outcome.link_clearance = std::min(outcome.link_clearance, links->clearance());

    if (motion.end == following::End::no_surface)
      throw UsageError("no surface is within sensing range of the start; give another --start");
    look({sensed, seen, motion, *follower_, outcome.path.back()});
    if (collisions_ && (outcome.collision = collisions_->look(at))) return "collision";
    if (motion.end != following::End::none) return std::string(following::name_of(motion.end));
    ++outcome.steps_in_mode[static_cast<std::size_t>(motion.mode)];
    at += simulation::moved(setup_.errors, motion.changes, set);
  }
  return "max-sets";
}

}  // namespace limpet::app
