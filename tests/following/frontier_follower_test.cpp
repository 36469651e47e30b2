// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/following/frontier/frontier_follower.hpp>

#include "initial_model.hpp"
#include "simulated_run.hpp"

namespace limpet::following {
namespace {

using Eigen::Vector3d;

struct Case {
  const char* world;
  double noise, area;
  int faces;
};

class FrontierRun : public testing::TestWithParam<Case> {};

TEST_P(FrontierRun, EndsByItselfWithAClosedModelAndKeepsItsDistance) {
  const auto [world, noise, area, faces] = GetParam();
  RunOptions options;
  options.noise = noise;
  options.strategy = Strategy::frontier;
  const Parameters parameters = usual_parameters(options.resolution);
  const RunResult run = run_following(make_world_mesh(world), options);
  EXPECT_EQ(run.end, End::complete);
  EXPECT_TRUE(run.closed) << run.open_edges << " open edges";
  EXPECT_EQ(run.polygons, faces);
  EXPECT_LT(run.encroachment, 1e-9);
  EXPECT_GT(run.clearance, 0.7 * parameters.clearance());
  EXPECT_LT(run.sets, 350 * area) << "the thesis's strategy takes 600 a unit of area";
}

INSTANTIATE_TEST_SUITE_P(Worlds, FrontierRun,
                         testing::Values(Case{"cube", 0, 6, 6}, Case{"cube", 0.002, 6, 6},
                                         Case{"L", 0.002, 7, 8}));

TEST(FrontierFollower, TheSameSeedGivesTheSameMotions) {
  RunOptions options;
  options.noise = 0.002;
  options.most_sets = 300;
  options.strategy = Strategy::frontier;
  const auto mesh = make_world_mesh("cube");
  EXPECT_EQ(run_following(mesh, options).places, run_following(mesh, options).places);
}

TEST(FrontierFollower, MotionsAreNoLongerThanTheCeiling) {
  RunOptions options;
  options.most_sets = 300;
  options.strategy = Strategy::frontier;
  run_following(make_world_mesh("cube"), options, [&](const Observation&, const Motion& motion) {
    EXPECT_LE(motion.displacement.norm(), options.resolution + 1e-12);
  });
}

/// What the follower does over some sets of the same readings, at one place.
Motion last_motion(const std::vector<model::SensorPoint>& readings, int sets) {
  const auto robot = kinematics::point_robot({});
  const kinematics::Posture posture(robot, Vector3d(0, 0, 0.1));
  const auto follower = make_frontier_follower(usual_parameters(0.05));
  model::Model model(model::Parameters{});
  Motion motion;
  for (int i = 0; i < sets && motion.end == End::none; ++i)
    motion = follower->next({model, model.update(readings), posture, readings});
  return motion;
}

TEST(FrontierFollower, EndsWhereThereIsNothing) { EXPECT_EQ(last_motion({}, 3).end, End::no_surface); }

TEST(FrontierFollower, GivesUpALonePointThatIsNeverFeltAgain) {
  const Motion motion = last_motion({{{0, 0, 0}, {0, 0, -1}, 0.1}}, 500);
  EXPECT_NE(motion.end, End::none);
}

TEST(FrontierFollower, RefusesUnsoundParameters) {
  Parameters parameters = usual_parameters(0.05);
  parameters.follow_distance = 0.04;
  EXPECT_THROW(make_frontier_follower(parameters), std::invalid_argument);
}

}  // namespace
}  // namespace limpet::following
