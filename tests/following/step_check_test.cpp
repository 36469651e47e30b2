// Copyright the limpet authors. GPL-3.0-or-later.
//
// What the check of a step says is clear is clear wherever one looks along the way.
#include <gtest/gtest.h>

#include <limpet/following/links/step_check.hpp>
#include <limpet/model/model.hpp>
#include <string>

#include "../kinematics/robots.hpp"

namespace limpet::following {
namespace {

using Eigen::Vector3d;
using kinematics::Configuration;
using kinematics::Posture;
namespace robots = kinematics::testing;

/// A square of side 1 somewhere, as a face known beforehand.
void add_square(model::Model& model, survey::Random& random) {
  const Eigen::Isometry3d pose = robots::random_pose(random);
  std::vector<Vector3d> cycle;
  for (const auto& [x, y] : {std::pair(-0.5, -0.5), {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
    cycle.push_back(pose * Vector3d(x, y, 0));
  model.add_initial(std::vector<model::InitialFace>{{{cycle}}});
}

kinematics::Robot arm_with_bodies(survey::Random& random) {
  kinematics::Robot robot = robots::random_chain(random, 4);
  for (auto& link : robot.links) link.body = {{Vector3d::Zero(), robots::random_vector(random, 0.6), 0.03}};
  return robot;
}

TEST(StepCheck, IsNeverWrongAboutAWayThatIsNotClear) {
  const std::uint64_t seed = 20261130;
  SCOPED_TRACE("seed " + std::to_string(seed));
  survey::Random random(seed);
  int clear = 0, refused = 0;
  for (int trial = 0; trial < 400; ++trial) {
    model::Model model(model::Parameters{});
    for (int i = 0; i < 3; ++i) add_square(model, random);
    const kinematics::Robot robot = arm_with_bodies(random);
    const Configuration at = robots::random_configuration(random, robot);
    const Posture posture(robot, at);
    Configuration changes(at.size());
    for (double& x : changes) x = random.uniform(-0.2, 0.2);
    const std::vector<Vector3d> readings = {robots::random_vector(random, 1)};
    std::vector<GuardedPart> parts;
    const auto body = kinematics::moving_body(robot, 0);
    for (const auto& part : body) parts.push_back({part, random.uniform(0.02, 0.2)});
    const model::View view = model.view();
    const Obstacles obstacles(view, readings, 0);
    const bool says = keeps_clear(posture, changes, obstacles, parts);
    ++(says ? clear : refused);

    bool is = true;
    for (const GuardedPart& guarded : parts) {
      const auto distance = [&](double t) {
        const auto capsule = kinematics::in_world(guarded.part, Posture(robot, at + t * changes));
        double least = (readings[0] - capsule.a).norm();
        for (double s = 0; s <= 1; s += 0.01)  // another way to the same distance, a little too large
          least = std::min(least, (readings[0] - capsule.a - s * (capsule.b - capsule.a)).norm());
        least -= capsule.radius;
        if (const auto near = view.nearest(capsule, 1)) least = std::min(least, near->distance);
        return least;
      };
      const double start = distance(0), least = std::min(guarded.least, start);
      for (double t = 0; t <= 1; t += 0.02) is &= distance(t) >= least - 0.011 * guarded.least;
      if (start < guarded.least) is &= distance(1) > start;
    }
    EXPECT_TRUE(is || !says) << "trial " << trial;
  }
  EXPECT_GT(clear, 30);
  EXPECT_GT(refused, 30);
}

TEST(StepCheck, WhatIsTooNearMayLeave) {
  model::Model model(model::Parameters{});
  model.add_initial(std::vector<model::InitialFace>{
      {{{Vector3d(-1, -1, 0), Vector3d(1, -1, 0), Vector3d(1, 1, 0), Vector3d(-1, 1, 0)}}}});
  kinematics::Robot robot;
  robot.links.resize(1);
  robot.links[0].joint = {kinematics::Joint::Kind::prismatic, Vector3d::UnitZ()};
  robot.links[0].body = {{Vector3d::Zero(), Vector3d::UnitX() * 0.5, 0.01}};
  const Posture posture(robot, Configuration::Constant(1, 0.05));  // at 0.04
  const auto body = kinematics::moving_body(robot, 0);
  const std::vector<GuardedPart> parts = {{body[0], 0.1}};
  const model::View view = model.view();
  const Obstacles obstacles(view, {}, 0);
  const auto keeps = [&](double by) {
    return keeps_clear(posture, Configuration::Constant(1, by), obstacles, parts);
  };
  EXPECT_TRUE(keeps(0.02));
  EXPECT_TRUE(keeps(0.5));
  EXPECT_FALSE(keeps(-0.001));
  EXPECT_FALSE(keeps(-0.2)) << "through the surface and out again";
  EXPECT_FALSE(keeps(0)) << "no motion leads away";
}

TEST(StepCheck, DistanceOfCapsulesIsThatOfTheirNearestPoints) {
  survey::Random random(9);
  for (int trial = 0; trial < 300; ++trial) {
    const auto v = [&] { return robots::random_vector(random, 1); };
    model::Capsule p{v(), v(), 0.05}, q{v(), v(), 0.1};
    if (trial % 5 == 0) q.b = q.a + (p.b - p.a);  // parallel
    if (trial % 7 == 0) p.b = p.a;                // a ball
    const kinematics::NearestOfCapsules nearest = kinematics::nearest_points(p, q);
    EXPECT_NEAR((nearest.on_first - nearest.on_second).norm() - 0.15, nearest.distance, 1e-12);
    double least = 1e9;
    for (double s = 0; s <= 1; s += 0.02)
      for (double t = 0; t <= 1; t += 0.02)
        least = std::min(least, (p.a + s * (p.b - p.a) - q.a - t * (q.b - q.a)).norm());
    EXPECT_LE(nearest.distance, least - 0.15 + 1e-12);
    EXPECT_GE(nearest.distance, least - 0.15 - 0.08);
    EXPECT_DOUBLE_EQ(kinematics::distance_between(p, q), nearest.distance);
  }
}

}  // namespace
}  // namespace limpet::following
