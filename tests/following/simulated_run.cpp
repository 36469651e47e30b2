// Copyright the limpet authors. GPL-3.0-or-later.
#include "simulated_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limpet/app/follow_run.hpp>
#include <limpet/app/follow_setup.hpp>
#include <limpet/evaluation/clearance.hpp>
#include <limpet/evaluation/true_surface.hpp>
#include <limpet/model/view.hpp>

namespace limpet::following {
namespace {

using Eigen::Vector3d;

app::FollowSetup setup_of(const RunOptions& options) {
  app::SceneFile scene;
  scene.world.mesh = options.shape;
  scene.world.initial_faces = options.known;
  scene.robot.heading.random = options.random_heading;
  scene.parameters.resolution = options.resolution;
  scene.parameters.follow_distance = scene.parameters.step = 2 * options.reach * options.resolution;
  scene.robot.sensing_range = 4 * options.reach * options.resolution;
  scene.errors.noise = options.noise;
  scene.seed = scene.errors.seed = options.seed;
  scene.strategy = options.strategy;
  scene.max_sets = options.most_sets;
  return app::make_setup(scene);
}

/// How near a motion leads to the model that it was chosen by.
void measure_distance(const Observation& seen, const Motion& motion, double clearance, RunResult& result) {
  const Vector3d before = seen.posture.control_point(), after = before + motion.displacement;
  const model::View view = seen.model.view();
  const auto near = view.nearest(model::Capsule{before, after, 0}, 1);
  const auto start_near = view.nearest(before, 1);
  if (!near || !start_near) return;
  result.model_clearance = std::min(result.model_clearance, near->distance);
  const double allowed = std::min(clearance, start_near->distance);
  result.encroachment = std::max(result.encroachment, allowed - near->distance);
}

}  // namespace

RunResult run_following(const RunOptions& options,
                        const std::function<void(const Observation&, const Motion&)>& watch) {
  const app::FollowSetup setup = setup_of(options);
  app::FollowRun run(setup);
  RunResult result;
  const app::FollowOutcome outcome = run.go([&](const app::FollowStep& step) {
    result.end = step.motion.end;
    if (watch) watch(step.seen, step.motion);
    measure_distance(step.seen, step.motion, setup.following.clearance(), result);
  });
  result.places = outcome.path;
  result.stuck_sensors = outcome.stuck_sensors;
  result.sets = static_cast<int>(outcome.path.size());
  result.sets_by_mode = outcome.steps_in_mode;
  result.clearance =
      evaluation::clearance_of(outcome.path, evaluation::TrueSurface(*setup.world.truth)).along;
  result.polygons = run.model().counts().polygons;
  result.confirmed = run.model().counts().confirmed;
  std::vector<model::View::Edge> open;
  run.model().view().open_edges(open);
  result.open_edges = std::ssize(open);
  return result;
}

void expect_good(const RunResult& run, std::int64_t polygons, double least_clearance_share) {
  EXPECT_EQ(run.end, End::complete);
  EXPECT_TRUE(run.closed()) << run.open_edges << " open edges";
  EXPECT_EQ(run.polygons, polygons);
  EXPECT_LT(run.encroachment, 1e-9);
  EXPECT_GT(run.clearance, least_clearance_share * usual_parameters(RunOptions{}.resolution).clearance());
}

Motion motion_at_rest(Strategy strategy, const std::vector<model::SensorPoint>& readings, int sets,
                      model::Model& model) {
  const auto robot = kinematics::point_robot({});
  const kinematics::Posture posture(robot, Vector3d(0, 0, 0.1));
  const auto follower = make_follower(strategy, usual_parameters(0.05));
  Motion motion;
  for (int i = 0; i < sets && motion.end == End::none; ++i)
    motion = follower->next({model, model.update(readings), posture, readings});
  return motion;
}

}  // namespace limpet::following
