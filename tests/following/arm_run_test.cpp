// Copyright the limpet authors. GPL-3.0-or-later.
//
// The thesis's arm feels an octahedron, whatever is wrong with it: judged by the truth.
#include <gtest/gtest.h>

#include <limpet/app/follow_judgement.hpp>
#include <limpet/app/follow_run.hpp>
#include <limpet/app/follow_setup.hpp>

#include "links_scene.hpp"

namespace limpet::following {
namespace {

using Eigen::Vector3d;
using kinematics::Configuration;
using kinematics::Posture;

app::SceneFile scene_of(Strategy strategy, std::uint64_t seed) {
  app::SceneFile scene;
  scene.world.mesh = "octahedron";
  scene.robot.kind = "arm";
  scene.strategy = strategy;
  scene.seed = scene.errors.seed = seed;
  scene.max_sets = 4000;
  return scene;
}

struct ArmRun {
  app::FollowOutcome outcome;
  std::size_t touches = 0;
  double link_clearance = 0;  ///< true
  double least_distance = 0;  ///< d_s
  std::int64_t open_edges = 0, polygons = 0;
};

ArmRun run(const app::SceneFile& scene) {
  const app::FollowSetup setup = app::make_setup(scene);
  app::FollowRun follow(setup);
  ArmRun run;
  run.outcome = follow.go([](const app::FollowStep&) {});
  const auto links = app::judge_links(setup, run.outcome);
  run.touches = links->collisions + links->self_collisions;
  run.link_clearance = links->to_surface;
  run.least_distance = setup.links->least_distance;
  const model::Counts counts = follow.model().counts();
  run.open_edges = counts.edges - 2 * counts.shared_edges;
  run.polygons = counts.polygons;
  return run;
}

/// Closed, with the faces of an octahedron, and no link came near it.
void expect_felt(const ArmRun& run) {
  EXPECT_EQ(run.outcome.ended, "complete");
  EXPECT_EQ(run.polygons, 8);
  EXPECT_EQ(run.open_edges, 0);
  EXPECT_EQ(run.touches, 0u);
  EXPECT_GT(run.link_clearance, 0.7 * run.least_distance);
  EXPECT_GT(run.outcome.link_clearance, 0.9 * run.least_distance);
}

TEST(ArmRun, FeelsAnOctahedronAndTouchesNothing) { expect_felt(run(scene_of(Strategy::frontier, 1))); }

/// The thesis's strategy leaves edges it could not close: as for the point robot.
TEST(ArmRun, ByTheThesissStrategyItTouchesNothingEither) {
  const ArmRun made = run(scene_of(Strategy::thesis, 1));
  EXPECT_EQ(made.outcome.ended, "complete");
  EXPECT_EQ(made.touches, 0u);
  EXPECT_GT(made.link_clearance, 0.5 * made.least_distance);
}

TEST(ArmRun, TheSameSeedGivesTheSameRun) {
  app::SceneFile scene = scene_of(Strategy::frontier, 3);
  scene.max_sets = 250;
  const ArmRun one = run(scene), other = run(scene);
  EXPECT_EQ(one.outcome.way, other.outcome.way);
}

TEST(ArmRun, NoiseOfJointsAndReadingsIsToldToTheModel) {
  app::SceneFile scene = scene_of(Strategy::frontier, 1);
  scene.errors.noise = 0.001;
  scene.errors.encoder_noise_rad = 0.001;
  expect_felt(run(scene));
}

/// The others do what is left to be done.
TEST(ArmRun, AJointThatSticksIsFound) {
  for (const std::size_t joint : {2u, 4u}) {
    app::SceneFile scene = scene_of(Strategy::frontier, 1);
    scene.errors.stuck_joints = {{joint, 50}};
    const ArmRun made = run(scene);
    EXPECT_EQ(made.outcome.stuck_joints, std::vector<std::size_t>{joint});
    EXPECT_EQ(made.outcome.ended, "complete");
    EXPECT_EQ(made.touches, 0u);
  }
}

/// Two sensors say δ wherever they are, until that is seen: what they led it after was no surface. It goes
/// back to where it felt one.
TEST(ArmRun, WhatLedItAwayIsNotTheEnd) {
  app::SceneFile scene = scene_of(Strategy::frontier, 1);
  scene.errors.stuck = {{3, 0.2}, {9, 0.2}};
  expect_felt(run(scene));
}

TEST(ArmRun, EndsWhereNoJointMoves) {
  app::SceneFile scene = scene_of(Strategy::frontier, 1);
  for (std::size_t joint = 0; joint < 6; ++joint) scene.errors.stuck_joints.push_back({joint, 0});
  const ArmRun made = run(scene);
  EXPECT_NE(made.outcome.ended, "max-sets");
  EXPECT_EQ(made.touches, 0u);
}

/// Stretched out, an arm cannot move its control point along itself: whatever it is asked, its changes are
/// small, and it comes out of it.
TEST(ArmRun, ASingularPostureIsLeft) {
  const kinematics::Robot robot = kinematics::arm();
  const model::Model nothing{model::Parameters{}};
  LinkMotion links(robot, usual_link_parameters(usual_parameters(0.05), Redundancy::programme));
  Configuration at = Configuration::Zero(6);
  const Vector3d start = Posture(robot, at).control_point();
  for (const Vector3d& way : {Vector3d(0, 0, 0.05), Vector3d(0, 0, -0.05)})
    for (int step = 0; step < 80; ++step) {
      const Posture posture(robot, at);
      links.look({nothing, {}, posture, {}});
      const Configuration changes = links.changes(way);
      ASSERT_TRUE(changes.allFinite());
      ASSERT_LE(changes.norm(), robot.ceilings.revolute_rad * (1 + 1e-9));
      at += changes;
    }
  Configuration bent = at;
  bent[1] += 0.05;  // no more than noise would do
  for (int step = 0; step < 80; ++step) {
    const Posture posture(robot, bent);
    links.look({nothing, {}, posture, {}});
    bent += links.changes(Vector3d(0, 0, -0.05));
  }
  EXPECT_LT(Posture(robot, bent).control_point().z(), start.z() - 0.5);
}

/// From nearer than d_s, links lead away, and then the run goes on.
TEST(ArmRun, AStartTooNearIsLeft) {
  const kinematics::Robot robot = kinematics::arm();
  const LinkParameters parameters = usual_link_parameters(usual_parameters(0.05), Redundancy::programme);
  Configuration at = Configuration::Zero(6);
  at[1] = 0.8, at[3] = 0.6;
  const LinkGuard guard(robot, parameters);
  const Posture start(robot, at);
  const model::Capsule link3 = kinematics::in_world(guard.body()[1], start);
  const Vector3d beside = (link3.a + link3.b) / 2 + Vector3d(0, link3.radius + 0.02, 0);
  LinkMotion links(robot, parameters);
  const model::Model nothing{model::Parameters{}};
  const std::vector<model::SensorPoint> reading = {{beside, Vector3d::UnitY(), 0.02}};
  for (int step = 0; step < 60; ++step) {
    const Posture posture(robot, at);
    links.look({nothing, {}, posture, step == 0 ? reading : std::vector<model::SensorPoint>{}});
    const double before = links.clearance();
    at += links.changes(Vector3d(0.02, 0, 0));
    const Posture after(robot, at);
    if (before < parameters.least_distance) {
      EXPECT_GE(links.obstacles().clearance(after, guard.body(), 1), before);
    }
  }
  EXPECT_GE(links.clearance(), 0.98 * parameters.least_distance);
}

}  // namespace
}  // namespace limpet::following
