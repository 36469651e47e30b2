// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/evaluation/arm_planner_internal.hpp>

#include "arm_worlds.hpp"

namespace limpet::evaluation {
namespace {

using kinematics::Configuration;
using testing::ArmWorld;
using testing::joints;

TEST(ArmRoadmap, LeadsOverFewNodesAndKnowsWhatIsNotReached) {
  ArmRoadmap map;
  for (const double at : {0.0, 1.0, 2.0, 3.0, 9.0}) map.add(joints({at}));
  for (const auto& [from, to] : {std::pair(0u, 1u), {1u, 2u}, {2u, 3u}, {0u, 2u}})
    map.join(from, to, map.at(to));
  EXPECT_EQ(map.way_to(3), (std::vector<Configuration>{joints({0}), joints({2}), joints({3})}));
  EXPECT_EQ(map.way_to(0), std::vector<Configuration>{joints({0})});
  EXPECT_FALSE(map.is_reached(4));
  EXPECT_TRUE(map.way_to(4).empty());
  map.join(4, 3, map.at(3));
  EXPECT_EQ(map.way_to(4).size(), 4u);
}

/// A way whose last turn goes on past half a turn ends there, a turn on from the node.
TEST(ArmRoadmap, TurnsTheShorterWayRound) {
  ArmRoadmap map;
  map.add(joints({3}));
  map.add(joints({-3}));
  const double on = 2 * std::numbers::pi - 3;
  map.join(0, 1, joints({on}));
  EXPECT_EQ(map.way_to(1), (std::vector<Configuration>{joints({3}), joints({on})}));
}

// ---- Clear configurations and ways -------------------------------------------------------------

ArmClearances usual_clearances() {
  return {testing::kArmResolution, testing::kArmResolution / 10, testing::kArmResolution / 10,
          testing::kArmResolution / 50, 1};
}

simulation::Mesh one_box() {
  simulation::BoxWorld world;
  world.add({0, 0, 0}, {2, 2, 2});
  return world.surface();
}

/// What is said to be clear is clear wherever one looks; and not nothing is.
TEST(ArmSpace, WaysThatJoinAreClearAllAlong) {
  const ArmWorld world(one_box(), testing::thesis_arm_at({-2, -1, 0}));
  const ArmSpace space(world.arm.robot, *world.truth, world.arm.start, usual_clearances());
  survey::Random random(3);
  int joined = 0, barred = 0;
  for (int i = 0; i < 200; ++i) {
    const Configuration from = space.random(random);
    const Configuration to = from + 0.2 * (space.near(from, space.random(random)) - from);
    const double room = testing::room_along(world, {from, to}, 50);
    if (space.joins(from, to)) {
      ++joined;
      EXPECT_TRUE(space.holds(from) && space.holds(to));
      EXPECT_GE(room, 0);
    } else if (room < 0) {
      ++barred;
    }
  }
  EXPECT_GT(joined, 20);
  EXPECT_GT(barred, 20);
}

TEST(ArmSpace, DistanceIsTheShorterWayRoundAndBoundsEveryMotion) {
  const ArmWorld world(one_box(), testing::thesis_arm_at({-2, -1, 0}));
  const ArmSpace space(world.arm.robot, *world.truth, world.arm.start, usual_clearances());
  survey::Random random(4);
  for (int i = 0; i < 200; ++i) {
    const Configuration from = space.random(random), to = space.random(random);
    const Configuration turned = space.near(from, to);
    EXPECT_TRUE(testing::are_same_place(to, turned));
    EXPECT_LE((turned - from).cwiseAbs().maxCoeff(), std::numbers::pi + 1e-12);
    const kinematics::Posture one(world.arm.robot, from), other(world.arm.robot, to);
    EXPECT_LE((one.control_point() - other.control_point()).norm(), space.distance(from, to) + 1e-9);
  }
}

/// From the start, a little each time.
std::vector<Configuration> known_way(const ArmWorld& world) {
  std::vector<Configuration> way;
  const Configuration change = joints({0.01, 0.005, 0, -0.01, 0, 0});
  for (int i = 0; i <= 30; ++i) way.push_back(world.arm.start + i * change);
  return way;
}

void expect_all_reached(const ArmRoadmap& map) {
  for (std::size_t node = 0; node < map.size(); ++node) EXPECT_TRUE(map.is_reached(node));
}

TEST(ArmPlanner, KeepsAKnownWayThinnedAndAllOfItsPlacesOnDemand) {
  const ArmWorld world(one_box(), testing::thesis_arm_at({-2, -1, 0}));
  const ArmSpace space(world.arm.robot, *world.truth, world.arm.start, usual_clearances());
  survey::Random random(5);
  ArmPlanner planner(space, world.arm.start, random);
  const std::vector<Configuration> way = known_way(world);
  planner.add_way(way);
  EXPECT_LT(planner.roadmap().size(), 10u);
  ASSERT_EQ(planner.known_count(), way.size());
  for (std::size_t i = 0; i < way.size(); ++i)
    EXPECT_EQ(planner.roadmap().at(planner.node_of_known(i)), way[i]);
  EXPECT_LE(planner.roadmap().size(), way.size() + 1);
  expect_all_reached(planner.roadmap());
}

/// The rest of a way that breaks off is joined otherwise; what reaches into the object is left out.
TEST(ArmPlanner, GoesRoundWhereAKnownWayIsNotClear) {
  const ArmWorld world(one_box(), testing::thesis_arm_at({-2, -1, 0}));
  const ArmSpace space(world.arm.robot, *world.truth, world.arm.start, usual_clearances());
  survey::Random random(6);
  std::vector<Configuration> way = known_way(world);
  const std::size_t clear = way.size();
  const auto bars = [&](const Configuration& at) { return testing::room_of(world, at) < 0; };
  while (way.size() < clear + 3)
    if (const Configuration at = space.random(random); bars(at)) way.push_back(at);
  way.push_back(world.arm.start + joints({0.5, 0.5, 0, 0.5, 0, 0}));
  ASSERT_FALSE(bars(way.back()));
  ArmPlanner planner(space, world.arm.start, random);
  planner.add_way(way);
  EXPECT_EQ(planner.known_count(), clear + 1);
  expect_all_reached(planner.roadmap());
}

}  // namespace
}  // namespace limpet::evaluation
