// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/evaluation/run_judgement.hpp>
#include <stdexcept>

#include "arm_worlds.hpp"
#include "run_worlds.hpp"

namespace limpet::evaluation {
namespace {

using Eigen::Vector3d;
using testing::kFollowDistance;
using testing::kRange;
using testing::kResolution;
using testing::model_of;
using testing::RunWorld;

// ---- Coverage ----------------------------------------------------------------------------------

TEST(Coverage, OfAPerfectModelIsWholeAndOfNoneIsNothing) {
  const RunWorld world(simulation::make_shape("L"));
  const Reachability truth = world.reachable();
  const Coverage whole = coverage_of(planar_faces(world.mesh), truth, kResolution);
  EXPECT_EQ(whole.of_reachable, 1);
  EXPECT_EQ(whole.of_all, 1);
  const Coverage nothing = coverage_of({}, truth, kResolution);
  EXPECT_EQ(nothing.of_reachable, 0);
  EXPECT_EQ(nothing.of_all, 0);
}

TEST(Coverage, ReachesOneResolutionBeyondTheModel) {
  const RunWorld world(testing::cube());
  const int top = testing::face_at(world.mesh, Vector3d::UnitZ(), {0.5, 0.5, 1});
  const Coverage found = coverage_of(planar_faces(model_of(world.mesh, [&](int f) { return f != top; })),
                                     world.reachable(), kResolution);
  const double rim = 1 - 0.8 * 0.8;
  for (std::size_t f = 0; f < found.faces.size(); ++f)
    EXPECT_NEAR(found.faces[f].of_all, static_cast<int>(f) == top ? rim : 1, 0.02);
  EXPECT_NEAR(found.of_all, (5 + rim) / 6, 0.005);
}

TEST(Coverage, CountsOnlyWhatIsReachable) {
  const RunWorld world(testing::hollow());
  const Reachability truth = world.reachable();
  const model::ModelRecord outside =
      model_of(world.mesh, [&](int f) { return truth.faces[static_cast<std::size_t>(f)].share > 0.5; });
  const Coverage found = coverage_of(planar_faces(outside), truth, kResolution);
  EXPECT_EQ(found.of_reachable, 1);
  EXPECT_NEAR(found.of_all, 24.0 / 30, 1e-9);
}

TEST(Coverage, GrowsWithTheModelAndTheResolution) {
  const RunWorld world(simulation::make_shape("step_hole"));
  const Reachability truth = world.reachable();
  const std::vector<PlanarFace> faces = planar_faces(world.mesh);
  double before = 0;
  for (std::size_t n = 1; n <= faces.size(); ++n) {
    const std::vector<PlanarFace> some(faces.begin(), faces.begin() + static_cast<std::ptrdiff_t>(n));
    const Coverage found = coverage_of(some, truth, kResolution);
    EXPECT_GE(found.of_all, before);
    EXPECT_LE(found.of_all, 1);
    EXPECT_GE(coverage_of(some, truth, 2 * kResolution).of_all, found.of_all);
    before = found.of_all;
  }
  EXPECT_EQ(before, 1);
}

// ---- Marks -------------------------------------------------------------------------------------

/// The open edges of a cube's model without its top, given up.
std::vector<GivenUp> rim_of_cube() {
  const Vector3d corner[] = {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  std::vector<GivenUp> marks;
  for (int i = 0; i < 4; ++i) marks.push_back({corner[i], corner[(i + 1) % 4], Vector3d::UnitZ()});
  return marks;
}

FalseUnreachable judged(const RunWorld& world, const Sensing& sensing, const model::ModelRecord& model,
                        const std::vector<GivenUp>& marks) {
  const Reachability truth = world.reachable(sensing);
  return false_unreachable(marks, truth, coverage_of(planar_faces(model), truth, kResolution), kResolution);
}

TEST(FalseUnreachable, IsAMarkWithReachableSurfaceBeyond) {
  const RunWorld world(testing::cube());
  const Sensing sensing = testing::point_robot_sensing();
  const FalseUnreachable found = judged(world, sensing, io::testing::open_cube(), rim_of_cube());
  EXPECT_EQ(found.count, 4u);
  for (const double area : found.areas) EXPECT_NEAR(area, 0.08, 0.01);  // a strip from λ to 2λ, less its ends
  EXPECT_EQ(judged(world, sensing, io::testing::cube(), rim_of_cube()).count, 0u);
  EXPECT_EQ(judged(world, sensing, io::testing::open_cube(), {}).count, 0u);
}

TEST(FalseUnreachable, IsNoneWhereNothingCanBeReached) {
  const RunWorld world(testing::cube());
  const Sensing sideways{{Vector3d::UnitX(), Vector3d::UnitY(), -Vector3d::UnitX(), -Vector3d::UnitY()},
                         kRange};
  EXPECT_EQ(judged(world, sideways, io::testing::open_cube(), rim_of_cube()).count, 0u);
}

TEST(FalseUnreachable, LooksOnlyBeyondTheEdge) {
  const RunWorld world(testing::cube());
  const Sensing sensing = testing::point_robot_sensing();
  // In the middle of a side, away from what is missing; and at the top, but turned the other way.
  const std::vector<GivenUp> marks{{{0.25, 0, 0.5}, {0.75, 0, 0.5}, Vector3d::UnitZ()},
                                   {{0, 0, 1}, {1, 0, 1}, Vector3d(0, -1, 0)}};
  const FalseUnreachable found = judged(world, sensing, io::testing::open_cube(), marks);
  EXPECT_EQ(found.count, 0u);
}

TEST(FalseUnreachable, WhatLiesAcrossAGapIsNotBeyond) {
  simulation::BoxWorld boxes;
  boxes.add({0, 0, 0}, {1, 1, 1});
  boxes.add({1.125, 0, 0}, {2, 1, 1});
  const RunWorld world(boxes.surface());
  const GivenUp mark{{1, 0, 1}, {1, 1, 1}, Vector3d::UnitX()};
  const FalseUnreachable found = judged(world, testing::point_robot_sensing(), io::testing::cube(), {mark});
  EXPECT_EQ(found.count, 0u);
}

// ---- All together ------------------------------------------------------------------------------

FollowingRun run_of(model::ModelRecord model) {
  FollowingRun run;
  run.path = {{-0.25, -0.25, -0.25}, {-0.25, -0.25, 0.5}, {-0.25, -0.25, 1.25}, {0.5, -0.25, 1.25}};
  run.model = std::move(model);
  return run;
}

RunJudgementOptions usual() {
  RunJudgementOptions options;
  options.resolution = kResolution;
  options.follow_distance = kFollowDistance;
  options.ceiling = kResolution;
  options.sensing = testing::point_robot_sensing();
  return options;
}

TEST(RunJudgement, OfAPerfectRun) {
  const RunJudgement found = judge_run(testing::cube(), run_of(io::testing::cube()), usual());
  EXPECT_EQ(found.coverage, 1);
  EXPECT_EQ(found.coverage_total, 1);
  EXPECT_EQ(found.reachable_share, 1);
  EXPECT_EQ(found.doubtful_share, 0);
  EXPECT_EQ(found.sets, 4u);
  EXPECT_NEAR(found.path_length, 2.25, 1e-12);
  EXPECT_EQ(found.collisions, 0u);
  EXPECT_NEAR(found.clearance_control_point, 0.25 * std::sqrt(2), 1e-12);
  EXPECT_EQ(found.false_unreachable, 0u);
  EXPECT_TRUE(found.isomorphic) << ::testing::PrintToString(found.topology.report.faults);
  EXPECT_EQ(found.topology.faces, 6);
  EXPECT_FALSE(found.tour.has_value());
}

TEST(RunJudgement, OfARunThatGaveUp) {
  FollowingRun run = run_of(io::testing::open_cube());
  run.marks = rim_of_cube();
  run.path.emplace_back(0.5, 0.5, 0.5);
  const RunJudgement found = judge_run(testing::cube(), run, usual());
  EXPECT_LT(found.coverage, 0.95);
  EXPECT_EQ(found.false_unreachable, 4u);
  EXPECT_EQ(found.collisions, 1u);
  EXPECT_EQ(found.clearance_control_point, 0);
  EXPECT_EQ(found.worst_step, 3u);
  EXPECT_FALSE(found.isomorphic);
}

TEST(RunJudgement, AsksForNoFaceThatCannotBeReached) {
  const simulation::Mesh mesh = testing::hollow();
  const RunWorld world(mesh);
  const Reachability truth = world.reachable();
  const auto outside = [&](int f) { return truth.faces[static_cast<std::size_t>(f)].share > 0.5; };
  const RunJudgement found = judge_run(mesh, run_of(model_of(mesh, outside)), usual());
  EXPECT_TRUE(found.isomorphic);
  EXPECT_EQ(found.topology.faces, 6);
  EXPECT_EQ(found.coverage, 1);
  EXPECT_NEAR(found.coverage_total, 24.0 / 30, 1e-9);
}

TEST(RunJudgement, LeavesSidesTowardsUnreachableFacesOpen) {
  const simulation::Mesh mesh = testing::slotted(0.1875, 0.75);
  const int left = testing::face_at(mesh, Vector3d::UnitX(), {0.5 - 0.09375, 0.5, 0.5});
  const int right = testing::face_at(mesh, -Vector3d::UnitX(), {0.5 + 0.09375, 0.5, 0.5});
  const int floor = testing::face_at(mesh, Vector3d::UnitZ(), {0.5, 0.5, 0.25});
  const auto outer = [&](int f) { return f != left && f != right && f != floor; };
  const RunJudgement without = judge_run(mesh, run_of(model_of(mesh, outer)), usual());
  EXPECT_EQ(without.topology.faces, mesh.face_count - 3);
  EXPECT_TRUE(without.isomorphic) << ::testing::PrintToString(without.topology.report.faults);
  EXPECT_LT(without.coverage_total, 1);
  // What was modelled of the slot takes no part, nor does it hurt.
  const RunJudgement with_walls =
      judge_run(mesh, run_of(model_of(mesh, [&](int f) { return f != floor; })), usual());
  EXPECT_TRUE(with_walls.isomorphic) << ::testing::PrintToString(with_walls.topology.report.faults);
  const RunJudgement less =
      judge_run(mesh, run_of(model_of(mesh, [&](int f) { return outer(f) && f != 0; })), usual());
  EXPECT_FALSE(less.isomorphic);
}

/// Beside the cube, with joints that let it get at two of its sides only.
PlacedArm hindered_arm() {
  PlacedArm arm;
  arm.robot = kinematics::placed(kinematics::arm(), Eigen::Isometry3d(Eigen::Translation3d(-1.5, 0.5, 0)));
  for (kinematics::RangeSensor& sensor : arm.robot.sensors) sensor.range = kRange;
  arm.robot.links[2].joint.low = -1.5, arm.robot.links[2].joint.high = 0.5;
  arm.robot.links[4].joint.low = 0, arm.robot.links[4].joint.high = 0.5;
  arm.robot.links[6].joint.low = 0, arm.robot.links[6].joint.high = 1;
  arm.start = testing::joints({0, -1, 0, 0.25, 0, 0.5});
  return arm;
}

TEST(RunJudgement, OfAnArmAsksForWhatAnArmCanFeel) {
  RunJudgementOptions options = usual();
  options.sensing = {};
  options.arm = hindered_arm();
  options.arm_samples = 200;
  const RunJudgement found = judge_run(testing::cube(), run_of(io::testing::cube()), options);
  EXPECT_EQ(found.coverage, 1);
  EXPECT_EQ(found.coverage_total, 1);
  EXPECT_GT(found.reachable_share, 0.1);
  EXPECT_LT(found.reachable_share, 0.9);
  EXPECT_NEAR(found.reachable_share + found.doubtful_share, 1, 1e-9) << "none is out of reach by its length";
  EXPECT_LT(found.topology.faces, 6);
  EXPECT_NEAR(static_cast<double>(found.reachability.samples.size()), 200, 20);
}

/// Marks are contradicted where the arm could have felt more, not wherever there is more.
TEST(RunJudgement, OfAnArmContradictsOnlyMarksThatItCouldFeelBeyond) {
  RunJudgementOptions options = usual();
  options.arm = hindered_arm();
  options.arm_samples = 200;
  const simulation::Mesh mesh = testing::cube();
  const int near = testing::face_at(mesh, -Vector3d::UnitX(), {0, 0.5, 0.5});
  const int far = testing::face_at(mesh, Vector3d::UnitX(), {1, 0.5, 0.5});
  const auto marked = [&](int face, double x) {
    FollowingRun run = run_of(model_of(mesh, [&](int f) { return f != face; }));
    run.marks = {{{x, 0, 1}, {x, 1, 1}, -Vector3d::UnitZ()}};
    return judge_run(mesh, run, options).false_unreachable;
  };
  EXPECT_EQ(marked(near, 0), 1u);
  EXPECT_EQ(marked(far, 1), 0u);
}

TEST(RunJudgement, RefusesWhatIsOutOfRange) {
  const simulation::Mesh mesh = testing::cube();
  const FollowingRun run = run_of(io::testing::cube());
  const auto with = [&](auto change) {
    RunJudgementOptions options = usual();
    change(options);
    return judge_run(mesh, run, options);
  };
  EXPECT_THROW(with([](auto& o) { o.resolution = 0; }), std::invalid_argument);
  EXPECT_THROW(with([](auto& o) { o.follow_distance = o.resolution; }), std::invalid_argument);
  EXPECT_THROW(with([](auto& o) { o.sensing.range = 0; }), std::invalid_argument);
  EXPECT_THROW(with([](auto& o) { o.spacing = -1; }), std::invalid_argument);
  EXPECT_THROW(with([](auto& o) { o.tour = true, o.ceiling = 0; }), std::invalid_argument);
  EXPECT_THROW(with([](auto& o) { o.arm = hindered_arm(), o.tour = true; }), std::invalid_argument);
  EXPECT_THROW(with([](auto& o) { o.arm = hindered_arm(), o.arm_samples = 0; }), std::invalid_argument);
  EXPECT_THROW(judge_run(mesh, FollowingRun{{}, run.model, {}}, usual()), std::invalid_argument);
}

}  // namespace
}  // namespace limpet::evaluation
