// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <functional>
#include <limpet/following/frontier/frontier_follower.hpp>
#include <string>

#include "initial_model.hpp"
#include "simulated_run.hpp"

namespace limpet::following {
namespace {

using Eigen::Vector3d;

struct FrontierCase {
  const char* world;
  double noise, area;
  int faces;
};

class FrontierRun : public ::testing::TestWithParam<FrontierCase> {};

TEST_P(FrontierRun, EndsByItselfWithAClosedModelAndKeepsItsDistance) {
  const auto [world, noise, area, faces] = GetParam();
  RunOptions options;
  options.shape = world;
  options.noise = noise;
  options.strategy = Strategy::frontier;
  const RunResult run = run_following(options);
  expect_good(run, faces, 0.7);
  EXPECT_LT(run.sets, 350 * area) << "the thesis's strategy takes 600 a unit of area";
}

INSTANTIATE_TEST_SUITE_P(Worlds, FrontierRun,
                         ::testing::Values(FrontierCase{"cube", 0, 6, 6}, FrontierCase{"cube", 0.002, 6, 6},
                                           FrontierCase{"L", 0.002, 7, 8}));

TEST(FrontierFollower, GivesUpALonePointThatIsNeverFeltAgain) {
  model::Model model(model::Parameters{});
  const Motion motion = motion_at_rest(Strategy::frontier, {{{0, 0, 0}, {0, 0, -1}, 0.1}}, 500, model);
  EXPECT_NE(motion.end, End::none);
}

/// What a robot with exact range finders feels of a model.
std::vector<model::SensorPoint> felt(const kinematics::Posture& posture, const model::View& world) {
  std::vector<model::SensorPoint> points;
  for (std::size_t i = 0; i < posture.robot().sensors.size(); ++i) {
    const auto sensor = posture.sensor(i);
    if (const auto hit = world.first_hit(sensor.position, sensor.axis, sensor.range))
      points.push_back(posture.sensor_point(i, hit->range));
  }
  return points;
}

/// Follower's law (4), for a robot that makes of each motion what `made` says from set `from` on.
void expect_end(double ceiling, int from, const std::function<Vector3d(const Vector3d&)>& made) {
  const model::Model world = shared_cube();
  kinematics::PointRobotOptions options;
  options.ceiling = ceiling;
  const auto robot = kinematics::point_robot(options);
  const auto follower = make_follower(Strategy::frontier, usual_parameters(0.05));
  model::Model model(model::Parameters{});
  Vector3d at(0.5, 0.5, 1.1);
  for (int set = 0; set < 20000; ++set) {
    const kinematics::Posture posture(robot, at);
    const auto readings = felt(posture, world.view());
    const Motion motion = follower->next({model, model.update(readings), posture, readings});
    if (motion.end != End::none) return;
    at += set < from ? motion.displacement : made(motion.displacement);
  }
  ADD_FAILURE() << "it has not ended";
}

/// From twice as far as usual, the first points are far from each other.
TEST(FrontierFollower, FindsAFirstPolygonFromFarAway) {
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    SCOPED_TRACE(seed);
    RunOptions options;
    options.strategy = Strategy::frontier;
    options.seed = seed;
    options.resolution = 0.025;
    options.reach = 2;
    options.most_sets = 150;
    EXPECT_GT(run_following(options).polygons, 0);
  }
}

/// On facets as wide as λ few points become polygons; those that do not are looked around, too.
TEST(FrontierFollower, GoesOnOverACurvedSurface) {
  for (const std::uint64_t seed : {1, 2}) {
    SCOPED_TRACE(seed);
    RunOptions options;
    options.shape = "sphere:32";
    options.strategy = Strategy::frontier;
    options.seed = seed;
    options.most_sets = 150;
    const RunResult run = run_following(options);
    EXPECT_EQ(run.end, End::none) << "complete after " << run.sets << " sets";
    EXPECT_GT(run.polygons, 10);
  }
}

TEST(FrontierFollower, EndsThoughTheRobotStandsStill) {
  for (const double ceiling : {0.05, 1.0}) {
    for (const int from : {0, 1, 50, 200, 400}) {
      SCOPED_TRACE("from set " + std::to_string(from) + ", ceiling " + std::to_string(ceiling));
      expect_end(ceiling, from, [](const Vector3d&) { return Vector3d(0, 0, 0); });
    }
  }
}

}  // namespace
}  // namespace limpet::following
