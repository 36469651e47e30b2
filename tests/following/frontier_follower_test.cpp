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
  options.shape = world;
  options.noise = noise;
  options.strategy = Strategy::frontier;
  const Parameters parameters = usual_parameters(options.resolution);
  const RunResult run = run_following(options);
  EXPECT_EQ(run.end, End::complete);
  EXPECT_TRUE(run.closed()) << run.open_edges << " open edges";
  EXPECT_EQ(run.polygons, faces);
  EXPECT_LT(run.encroachment, 1e-9);
  EXPECT_GT(run.clearance, 0.7 * parameters.clearance());
  EXPECT_LT(run.sets, 350 * area) << "the thesis's strategy takes 600 a unit of area";
}

INSTANTIATE_TEST_SUITE_P(Worlds, FrontierRun,
                         testing::Values(Case{"cube", 0, 6, 6}, Case{"cube", 0.002, 6, 6},
                                         Case{"L", 0.002, 7, 8}));

TEST(FrontierFollower, GivesUpALonePointThatIsNeverFeltAgain) {
  model::Model model(model::Parameters{});
  const Motion motion = motion_at_rest(Strategy::frontier, {{{0, 0, 0}, {0, 0, -1}, 0.1}}, 500, model);
  EXPECT_NE(motion.end, End::none);
}

}  // namespace
}  // namespace limpet::following
