// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/following/thesis/thesis_follower.hpp>
#include <limpet/simulation/world.hpp>

#include "initial_model.hpp"
#include "simulated_run.hpp"

namespace limpet::following {
namespace {

using Eigen::Vector3d;

struct ThesisCase {
  const char* world;
  double noise;
  int faces;
};

class ThesisRun : public ::testing::TestWithParam<ThesisCase> {};

TEST_P(ThesisRun, EndsByItselfWithAClosedModelAndKeepsItsDistance) {
  const auto [world, noise, faces] = GetParam();
  RunOptions options;
  options.shape = world;
  options.noise = noise;
  const RunResult run = run_following(options);
  expect_good(run, faces, 0.5);
  for (const Mode mode : {Mode::current_segment, Mode::current_edge, Mode::gap})
    EXPECT_GT(run.sets_by_mode[static_cast<std::size_t>(mode)], 0) << name_of(mode);
}

INSTANTIATE_TEST_SUITE_P(Worlds, ThesisRun,
                         ::testing::Values(ThesisCase{"cube", 0, 6}, ThesisCase{"cube", 0.002, 6},
                                           ThesisCase{"L", 0.002, 8},
                                           ThesisCase{"thin_plate:0.25", 0.002, 6}));

TEST(ThesisFollower, ARobotThatDoesNotMoveEndsTheRun) {
  auto model = initial_model({{rectangle(-1, -1, 1, 1)}});
  EXPECT_EQ(motion_at_rest(Strategy::thesis, {}, 500, model).end, End::stopped);
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

}  // namespace
}  // namespace limpet::following
