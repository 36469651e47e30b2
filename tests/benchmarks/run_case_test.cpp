// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/app/scene_file.hpp>

#include "following/run_case.hpp"

namespace limpet::benchmarks {
namespace {

TEST(SceneText, WhatIsSetLastIsWhatASceneFileSays) {
  RunPlan plan;
  plan.strategy = "thesis";
  SceneText scene = scene_of(plan, "cube");
  scene.set("parameters", "resolution", 0.1).set("parameters", "resolution", 0.04);
  scene.set_text("initial", "faces", "[0, 5]");
  const app::SceneFile read = app::parse_scene(scene.toml(), "");
  EXPECT_EQ(read.world.mesh, "cube");
  EXPECT_EQ(read.world.initial_faces, (std::vector<int>{0, 5}));
  EXPECT_EQ(read.parameters.resolution, 0.04);
  EXPECT_EQ(read.errors.noise, plan.noise);
  EXPECT_EQ(read.strategy, following::Strategy::thesis);
  EXPECT_TRUE(read.robot.heading.random);
}

TEST(SceneText, AResolutionOfZeroIsLeftToTheObject) {
  RunPlan plan;
  plan.resolution = 0;
  EXPECT_FALSE(app::parse_scene(scene_of(plan, "cube").toml(), "").parameters.resolution);
}

TEST(RunCases, EachSeedOfThePlanHasOneThatCanBeToldToAProcess) {
  RunPlan plan;
  plan.first_seed = 7;
  plan.starts = 2;
  std::vector<RunCase> cases;
  add_runs(plan, "a cube", scene_of(plan, "cube"), cases);
  ASSERT_EQ(cases.size(), 2u);
  EXPECT_EQ(seeds_text(plan), "seeds 7 to 8");
  const RunCase told = Json::parse(Json(cases[1]).dump()).get<RunCase>();
  EXPECT_EQ(told.name, "a cube");
  EXPECT_EQ(told.scene, cases[1].scene);
  EXPECT_EQ(app::parse_scene(told.scene, "").seed, 8u);
}

}  // namespace
}  // namespace limpet::benchmarks
