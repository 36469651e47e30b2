// Copyright the limpet authors. GPL-3.0-or-later.
//
// What every strategy keeps to.
#include <gtest/gtest.h>

#include <limpet/following/follower.hpp>

#include "simulated_run.hpp"

namespace limpet::following {
namespace {

class AnyFollower : public ::testing::TestWithParam<Strategy> {};

TEST_P(AnyFollower, TheSameSeedGivesTheSameMotions) {
  RunOptions options;
  options.noise = 0.002;
  options.most_sets = 400;
  options.strategy = GetParam();
  EXPECT_EQ(run_following(options).places, run_following(options).places);
}

TEST_P(AnyFollower, MotionsAreNoLongerThanTheStepAndTheCeiling) {
  RunOptions options;
  options.most_sets = 300;
  options.strategy = GetParam();
  run_following(options, [&](const Observation&, const Motion& motion) {
    EXPECT_LE(motion.displacement.norm(), options.resolution + 1e-12);  // the robot's ceiling γ
  });
}

/// As in thesis §4.3. Some of the starts are before a known face, far from all that is to be felt.
TEST_P(AnyFollower, ClosesACubeThreeFacesOfWhichAreKnown) {
  std::int64_t confirmed = 0;
  for (const double noise : {0.0, 0.002})
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
      RunOptions options;
      options.noise = noise;
      options.strategy = GetParam();
      options.seed = seed;
      options.known = {0, 1, 2};
      options.most_sets = 6000;
      const RunResult run = run_following(options);
      SCOPED_TRACE(seed);
      EXPECT_EQ(run.end, End::complete);
      EXPECT_TRUE(run.closed());
      EXPECT_EQ(run.polygons, 6);
      EXPECT_GT(run.clearance, 0);
      confirmed += run.confirmed;
    }
  EXPECT_GT(confirmed, 0);
}

TEST_P(AnyFollower, EndsWhereThereIsNothing) {
  model::Model model(model::Parameters{});
  EXPECT_EQ(motion_at_rest(GetParam(), {}, 1, model).end, End::no_surface);
}

TEST_P(AnyFollower, RefusesUnsoundParameters) {
  Parameters parameters = usual_parameters(0.05);
  parameters.follow_distance = 0.04;
  EXPECT_THROW(make_follower(GetParam(), parameters), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(Strategies, AnyFollower, ::testing::Values(Strategy::frontier, Strategy::thesis));

}  // namespace
}  // namespace limpet::following
