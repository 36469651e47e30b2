// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <limpet/app/collision_watch.hpp>
#include <limpet/app/follow_setup.hpp>
#include <limpet/following/follower.hpp>
#include <limpet/following/sensor_watch.hpp>
#include <limpet/model/model.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace limpet::app {

/// One set of a run, for who looks on.
struct FollowStep {
  const simulation::Sensed& sensed;
  const following::Observation& seen;  ///< what the follower was told
  const following::Motion& motion;
  const following::Follower& follower;
  const Eigen::Vector3d& control_point;  ///< where it truly is
};

/// What a run has come to. Times are of each set, in microseconds.
struct FollowOutcome {
  std::string ended;                   ///< complete, max-sets, max-seconds, interrupted, stopped or collision
  std::optional<Collision> collision;  ///< that ended it
  std::vector<Eigen::Vector3d> path;   ///< where the control point truly was at each set
  std::vector<kinematics::Configuration> way;  ///< and the robot; of one with links, and not in a replay
  double link_clearance =
      std::numeric_limits<double>::infinity();  ///< smallest, to the model and to readings
  std::int64_t readings = 0;
  std::array<std::int64_t, following::kModeCount> steps_in_mode{};
  following::Marks marks;                  ///< by the model before it was finished
  std::vector<std::size_t> stuck_joints;   ///< that were held still, once they were found not to move
  std::vector<std::size_t> stuck_sensors;  ///< whose readings were left out, from when they were found stuck
  std::vector<double> step_us, model_us;   ///< step_us: empty when nothing was decided, in a replay
};

/// A simulated run of following: the loop of thesis §1.2.
class FollowRun {
 public:
  /// The setup must outlive it. Throws UsageError when the model's parameters or initial faces make no sense.
  explicit FollowRun(const FollowSetup&);

  /// Steps until the follower is done, the sets or the time are used up, the robot has collided where that is
  /// to end the run (FollowSetup::end_at_collision), or the run is interrupted; and then,
  /// unless it was interrupted, finishes the model. look(step) is called after each set. Throws UsageError
  /// when the start senses no surface.
  FollowOutcome go(const std::function<void(const FollowStep&)>& look);

  const model::Model& model() const { return model_; }

 private:
  simulation::Sensed sense(const kinematics::Configuration& at);
  void finish(FollowOutcome&);
  std::string go_on(FollowOutcome&, const std::function<void(const FollowStep&)>& look);

  const FollowSetup& setup_;
  model::Model model_;
  std::unique_ptr<following::Follower> follower_;
  simulation::Sensing sensing_;
  following::SensorWatch watch_;
  std::optional<CollisionWatch> collisions_;  ///< where they end the run
};

}  // namespace limpet::app
