// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/evaluation/link_clearance.hpp>
#include <limpet/simulation/scene.hpp>
#include <limpet/survey/random.hpp>
#include <vector>

namespace limpet::evaluation {
namespace {

using Eigen::Vector3d;
using kinematics::Configuration;

/// A rod of radius 0.1 that stands upright and slides along x.
kinematics::Robot rod() {
  kinematics::Robot robot;
  robot.links.resize(1);
  robot.links[0].joint = {kinematics::Joint::Kind::prismatic, Vector3d::UnitX()};
  robot.links[0].body = {{Vector3d(0, 0.5, -1), Vector3d(0, 0.5, 2), 0.1}};
  return robot;
}

std::vector<Configuration> way(std::initializer_list<double> places) {
  std::vector<Configuration> result;
  for (const double x : places) result.push_back(Configuration::Constant(1, x));
  return result;
}

TEST(LinkClearance, IsThatOfTheNearestPlaceOnTheWay) {
  const simulation::Mesh cube = simulation::make_scene("cube").mesh;
  const simulation::Bounds bounds = simulation::bounds_of(cube);
  const TrueSurface truth(cube);
  const double low = bounds.low.x();
  const auto clear = link_clearance(rod(), way({low - 2, low - 0.4, low - 1}), truth, 0.01);
  EXPECT_NEAR(clear.to_surface, 0.3, 1e-9);
  EXPECT_EQ(clear.collisions, 0u);
  EXPECT_EQ(clear.worst, 0u) << "the step that came there, the first of equals";
  const auto touching =
      link_clearance(rod(), way({low - 2, low - 1, low - 0.05, low - 1, low - 2}), truth, 0.01);
  EXPECT_NEAR(touching.to_surface, -0.05, 1e-9);
  EXPECT_EQ(touching.collisions, 2u) << "there and back";
}

/// Between two places that are clear there may be a wall.
TEST(LinkClearance, SeesWhatIsPassedThroughBetweenTwoPlaces) {
  const simulation::Mesh cube = simulation::make_scene("cube").mesh;
  const simulation::Bounds bounds = simulation::bounds_of(cube);
  const auto through =
      link_clearance(rod(), way({bounds.low.x() - 1, bounds.high.x() + 1}), TrueSurface(cube), 0.01);
  EXPECT_EQ(through.collisions, 1u);
  EXPECT_LT(through.to_surface, 0);
}

TEST(LinkClearance, LinksThatAreNotJoinedAreKeptApart) {
  kinematics::Robot robot;
  for (std::size_t i = 0; i < 3; ++i) {
    kinematics::Link link;
    if (i > 0) {
      link.parent = i - 1;
      link.mounting.translation() = Vector3d(1, 0, 0);
    }
    link.joint = {kinematics::Joint::Kind::revolute, Vector3d::UnitZ()};
    link.body = {{Vector3d::Zero(), Vector3d(1, 0, 0), 0.05}};
    robot.links.push_back(link);
  }
  const TrueSurface far(simulation::make_scene("cube").mesh);
  robot = kinematics::placed(robot, Eigen::Isometry3d(Eigen::Translation3d(0, 0, 50)));
  const std::vector<Configuration> fold = {Eigen::Vector3d(0, 1.5, 1.5), Eigen::Vector3d(0, 2.2, 2.5)};
  const auto folded = link_clearance(robot, fold, far, 0.005);
  EXPECT_EQ(folded.self_collisions, 1u) << "the third link crosses the first";
  EXPECT_LT(folded.to_itself, 0);
  EXPECT_EQ(link_clearance(robot, std::vector<Configuration>{fold[0]}, far, 0.005).self_collisions, 0u);
}

/// Watched step by step, just the steps that collide are told.
TEST(LinkClearance, AWatchTellsTheStepsThatCollide) {
  const simulation::Mesh cube = simulation::make_scene("cube").mesh;
  const TrueSurface truth(cube);
  const kinematics::Robot robot = rod();
  const double low = simulation::bounds_of(cube).low.x();
  survey::Random random(5);
  std::vector<Configuration> places = way({low - 1});
  for (int i = 0; i < 200; ++i) places.push_back(Configuration::Constant(1, low + random.uniform(-1, 2)));
  const LinkWatch watch(robot, truth, 0.01, places.front());
  std::size_t told = 0;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const LinkClearance step = watch.measure(places[i], places[i + 1]);
    const auto touched = watch.touched(places[i], places[i + 1]);
    ASSERT_EQ(touched.has_value(), step.collisions > 0) << places[i] << " to " << places[i + 1];
    told += touched.has_value();
    if (touched) {
      EXPECT_EQ(touched->to_surface, step.to_surface);
    }
  }
  EXPECT_EQ(told, link_clearance(robot, places, truth, 0.01).collisions);
  EXPECT_GT(told, 0u);
  EXPECT_LT(told, 200u);
}

/// What touches when all joints are at rest is made so, though it does not in the first configuration.
TEST(LinkClearance, WhatTouchesAtRestIsMadeSo) {
  kinematics::Robot robot;
  for (const double x : {0.0, 0.6, -0.3}) {  // rods: at rest the third is beside the first
    kinematics::Link link;
    if (!robot.links.empty()) link.parent = robot.links.size() - 1;
    link.mounting.translation() = Vector3d(x, 0, robot.links.empty() ? 50 : 0);
    link.joint = {kinematics::Joint::Kind::revolute, Vector3d::UnitZ()};
    link.body = {{Vector3d::Zero(), Vector3d(0, 0, 0.5), 0.2}};
    robot.links.push_back(link);
  }
  const TrueSurface far(simulation::make_scene("cube").mesh);
  const std::vector<Configuration> folding = {Eigen::Vector3d(0, 3, 0), Eigen::Vector3d(0, 0, 0)};
  EXPECT_EQ(link_clearance(robot, folding, far, 0.005).self_collisions, 0u);
  robot.links[1].joint.low = 1;  // not where it rests
  EXPECT_EQ(link_clearance(robot, folding, far, 0.005).self_collisions, 1u);
}

}  // namespace
}  // namespace limpet::evaluation
