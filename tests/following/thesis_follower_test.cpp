// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/following/thesis/thesis_follower.hpp>
#include <limpet/simulation/world.hpp>

#include "initial_model.hpp"
#include "simulated_run.hpp"

namespace limpet::following {
namespace {

using Eigen::Vector3d;

struct Case {
  const char* world;
  double noise;
  int faces;
};

class ThesisRun : public testing::TestWithParam<Case> {};

TEST_P(ThesisRun, EndsByItselfWithAClosedModelAndKeepsItsDistance) {
  const auto [world, noise, faces] = GetParam();
  RunOptions options;
  options.noise = noise;
  const Parameters parameters = usual_parameters(options.resolution);
  const RunResult run = run_following(make_world_mesh(world), options);
  EXPECT_EQ(run.end, End::complete);
  EXPECT_TRUE(run.closed) << run.open_edges << " open edges";
  EXPECT_EQ(run.polygons, faces);
  EXPECT_LT(run.encroachment, 1e-9);
  EXPECT_GT(run.clearance, 0.5 * parameters.clearance());
  for (const Mode mode : {Mode::current_segment, Mode::current_edge, Mode::gap})
    EXPECT_GT(run.sets_by_mode[static_cast<std::size_t>(mode)], 0) << name_of(mode);
}

INSTANTIATE_TEST_SUITE_P(Worlds, ThesisRun,
                         testing::Values(Case{"cube", 0, 6}, Case{"cube", 0.002, 6}, Case{"L", 0.002, 8},
                                         Case{"thin_plate:0.25", 0.002, 6}));

TEST(ThesisFollower, TheSameSeedGivesTheSameMotions) {
  RunOptions options;
  options.noise = 0.002;
  options.most_sets = 400;
  const auto mesh = make_world_mesh("cube");
  const RunResult a = run_following(mesh, options), b = run_following(mesh, options);
  EXPECT_EQ(a.places, b.places);
}

TEST(ThesisFollower, MotionsAreNoLongerThanTheStepAndTheCeiling) {
  RunOptions options;
  options.most_sets = 300;
  run_following(make_world_mesh("cube"), options, [&](const Observation&, const Motion& motion) {
    EXPECT_LE(motion.displacement.norm(), options.resolution + 1e-12);  // the robot's ceiling γ
  });
}

/// What the follower does over some sets of the same readings, at one place.
Motion last_motion(const std::vector<model::SensorPoint>& readings, int sets, model::Model& model) {
  const auto robot = kinematics::point_robot({});
  const kinematics::Posture posture(robot, Vector3d(0, 0, 0.1));
  const auto follower = make_thesis_follower(usual_parameters(0.05));
  Motion motion;
  for (int i = 0; i < sets && motion.end == End::none; ++i)
    motion = follower->next({model, model.update(readings), posture, readings});
  return motion;
}

TEST(ThesisFollower, EndsWhereThereIsNothing) {
  model::Model model(model::Parameters{});
  EXPECT_EQ(last_motion({}, 1, model).end, End::no_surface);
}

TEST(ThesisFollower, ARobotThatDoesNotMoveEndsTheRun) {
  auto model = initial_model({{rectangle(-1, -1, 1, 1)}});
  EXPECT_EQ(last_motion({}, 500, model).end, End::stopped);
}

TEST(ThesisFollower, GivesUpALonePointSegment) {
  // One point in space, of which nothing more is ever seen: it is circled, and given up.
  const auto robot = kinematics::point_robot({});
  model::Model model(model::Parameters{});
  const auto follower = make_thesis_follower(usual_parameters(0.05));
  kinematics::Posture posture(robot, Vector3d(0, 0, 0.15));
  std::vector<model::SensorPoint> readings{{Vector3d::Zero(), -Vector3d::UnitZ(), 0.15}};
  int sets = 0;
  for (;; ++sets) {
    ASSERT_LT(sets, 500);
    const Motion motion = follower->next({model, model.update(readings), posture, readings});
    if (motion.end != End::none) {
      EXPECT_EQ(motion.end, End::complete);
      break;
    }
    EXPECT_EQ(motion.mode, Mode::point);
    posture = kinematics::Posture(
        robot, posture.configuration() + kinematics::actuator_changes(posture, motion.displacement));
    readings.clear();
  }
  EXPECT_GT(sets, 40);  // four slices
}

TEST(ThesisFollower, KnownFacesThatAreClosedAreComplete) {
  auto model = shared_cube();
  const auto robot = kinematics::point_robot({});
  const kinematics::Posture posture(robot, Vector3d(0.5, 0.5, 1.1));
  EXPECT_EQ(make_thesis_follower(usual_parameters(0.05))->next({model, {}, posture, {}}).end, End::complete);
}

TEST(ThesisFollower, RefusesUnsoundParameters) {
  Parameters parameters = usual_parameters(0.05);
  parameters.follow_distance = 0.04;
  EXPECT_THROW(make_thesis_follower(parameters), std::invalid_argument);
}

}  // namespace
}  // namespace limpet::following
