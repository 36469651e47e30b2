// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/evaluation/link_clearance.hpp>
#include <stdexcept>

#include "arm_worlds.hpp"
#include "run_worlds.hpp"

namespace limpet::evaluation {
namespace {

using Eigen::Vector3d;
using kinematics::Configuration;
using kinematics::Posture;
using testing::ArmWorld;
using testing::joints;
using testing::kArmRange;
using testing::kArmResolution;

// ---- A planar arm, of which all is known -------------------------------------------------------

constexpr double kHalfTurn = std::numbers::pi;

PlacedArm planar_arm_pointing(double angle_rad) {
  return {testing::planar_arm(), joints({angle_rad, 0}), {}};
}

simulation::BoxWorld wall() {
  simulation::BoxWorld boxes;
  boxes.add({1.5, -3, -0.5}, {1.75, 3, 0.5});
  return boxes;
}

/// Stretched out and a range on: no farther, and as far as that.
TEST(ArmReach, OfAWallIsACircle) {
  ArmWorld world(wall().surface(), planar_arm_pointing(kHalfTurn));
  const double farthest = std::sqrt(2.4 * 2.4 - 1.5 * 1.5);
  for (const double side : {-1.0, 1.0}) {
    for (double y = 0; y < farthest - 0.03; y += 0.1)
      EXPECT_EQ(world.verdict({1.5, side * y, 0}, -Vector3d::UnitX()), Verdict::yes) << y;
    EXPECT_EQ(world.verdict({1.5, side * (farthest + 0.01), 0}, -Vector3d::UnitX()), Verdict::no);
  }
  EXPECT_EQ(world.verdict({1.5, 0, 0.1}, -Vector3d::UnitX()), Verdict::doubtful) << "not in the arm's plane";
  EXPECT_EQ(world.verdict({1.75, 0, 0}, Vector3d::UnitX()), Verdict::doubtful) << "behind the wall";
}

/// Straight on the way is barred; with a bent elbow it is not.
TEST(ArmReach, GoesRoundWhatIsInTheWay) {
  simulation::BoxWorld boxes = wall();
  boxes.add({1, -0.25, -0.5}, {1.125, 0.25, 0.5});
  ArmWorld world(boxes.surface(), planar_arm_pointing(kHalfTurn));
  EXPECT_EQ(world.verdict({1.5, 0, 0}, -Vector3d::UnitX()), Verdict::yes);
  EXPECT_EQ(world.verdict({1, 0, 0}, -Vector3d::UnitX()), Verdict::yes);
  boxes.add({1.125, -2.5, -0.5}, {1.25, 2.5, 0.5});
  ArmWorld closed(boxes.surface(), planar_arm_pointing(kHalfTurn));
  EXPECT_NE(closed.verdict({1.5, 0, 0}, -Vector3d::UnitX()), Verdict::yes)
      << "too narrow behind the long one";
}

/// Between two walls that the arm fits between at a turn only: it sees what is on its side, and there is no
/// way to the other though it could stand there.
TEST(ArmReach, NeedsAWayFromTheStart) {
  simulation::BoxWorld boxes;
  boxes.add({-3, 0.5, -0.5}, {-0.125, 0.75, 0.5});
  boxes.add({-3, -0.75, -0.5}, {-0.125, -0.5, 0.5});
  boxes.add({0.5, -3, -0.5}, {0.75, 3, 0.5});
  boxes.add({-0.125, 0.5, -0.5}, {0.5, 0.75, 0.5});
  boxes.add({-0.125, -0.75, -0.5}, {0.5, -0.5, 0.5});
  ArmWorld world(boxes.surface(), planar_arm_pointing(kHalfTurn));
  EXPECT_EQ(world.verdict({-1.5, 0.5, 0}, -Vector3d::UnitY()), Verdict::yes);
  EXPECT_NE(world.verdict({0, 0.75, 0}, Vector3d::UnitY()), Verdict::yes) << "outside the passage";
}

TEST(ArmReach, NothingInAClosedBoxIsReachable) {
  simulation::BoxWorld boxes;
  boxes.add({1, -0.75, -0.75}, {2.5, 0.75, 0.75});
  boxes.carve({1.25, -0.5, -0.5}, {2.25, 0.5, 0.5});
  ArmWorld world(boxes.surface(), planar_arm_pointing(kHalfTurn));
  EXPECT_EQ(world.verdict({1.75, 0.5, 0}, -Vector3d::UnitY()), Verdict::no);
  EXPECT_EQ(world.verdict({2.25, 0, 0}, -Vector3d::UnitX()), Verdict::no);
  EXPECT_EQ(world.verdict({1, 0, 0}, -Vector3d::UnitX()), Verdict::yes);
}

TEST(ArmReach, KeepsTheLimitsOfJoints) {
  PlacedArm arm = planar_arm_pointing(1.5);
  arm.robot.links[0].joint.low = 0, arm.robot.links[0].joint.high = 3;
  arm.robot.links[1].joint.low = -0.1, arm.robot.links[1].joint.high = 0.1;
  simulation::BoxWorld boxes;
  boxes.add({-3, 2.25, -0.5}, {3, 2.5, 0.5});
  boxes.add({-3, -2.5, -0.5}, {3, -2.25, 0.5});
  ArmWorld world(boxes.surface(), arm);
  EXPECT_EQ(world.verdict({0, 2.25, 0}, -Vector3d::UnitY()), Verdict::yes);
  EXPECT_EQ(world.verdict({0, -2.25, 0}, Vector3d::UnitY()), Verdict::doubtful)
      << "in reach but for the limits";
}

// ---- The thesis's arm --------------------------------------------------------------------------

simulation::Mesh plate_and_cube() {
  simulation::BoxWorld boxes;
  boxes.add({0, 0, 0}, {2, 2, 2});
  boxes.add({-0.75, 0, 0}, {-0.5, 2, 1.5});
  return boxes.surface();
}

/// Each is looked at again: the robot stands clear, sees the sample, and comes there by a way that is clear.
TEST(ArmReach, WhatIsReachableIsSeenFromWhereAClearWayLeads) {
  ArmWorld world(plate_and_cube(), testing::thesis_arm_at({-3, -1, 0}));
  const ArmReachability found = world.look(300);
  std::size_t seen = 0;
  for (std::size_t i = 0; i < found.reachability.samples.size(); ++i) {
    if (found.reachability.verdicts[i] != Verdict::yes) continue;
    ++seen;
    const SurfaceSample& sample = found.reachability.samples[i];
    const auto [node, number] = found.sightings[i];
    const std::vector<Configuration> way = world.reach->roadmap().way_to(node);
    ASSERT_FALSE(way.empty());
    EXPECT_EQ(way.front(), world.arm.start);
    EXPECT_TRUE(testing::are_same_place(way.back(), world.reach->roadmap().at(node)));
    const Posture::Sensor sensor = Posture(world.arm.robot, way.back()).sensor(number);
    EXPECT_LT((sensor.position - found.reachability.seen_from[i]).norm(), 1e-9);
    const double t = (sample.at - sensor.position).dot(sensor.axis);
    EXPECT_GT(t, 0);
    EXPECT_LE(t, sensor.range);
    EXPECT_LE((sensor.position + t * sensor.axis - sample.at).norm(), 0.01 * kArmResolution);
    EXPECT_LE(sensor.axis.dot(sample.normal), -0.087);
    EXPECT_NEAR(
        world.truth->first_crossing(sensor.position, (sample.at - sensor.position).normalized()).value(), t,
        0.01 * kArmResolution);
    if (seen % 25 != 0) continue;  // ways are long to look at
    EXPECT_GE(testing::room_along(world, way, 20), 0);
    EXPECT_GT(link_clearance(world.arm.robot, way, *world.truth, kArmResolution / 5).to_itself, 0);
  }
  EXPECT_GT(seen, 150u);
}

TEST(ArmReach, SaysTheSameEveryTime) {
  ArmWorld one(plate_and_cube(), testing::thesis_arm_at({-3, -1, 0}));
  ArmWorld other(plate_and_cube(), testing::thesis_arm_at({-3, -1, 0}));
  const ArmReachability first = one.look(100), second = other.look(100);
  EXPECT_EQ(first.reachability.verdicts, second.reachability.verdicts);
  EXPECT_EQ(one.reach->roadmap().size(), other.reach->roadmap().size());
  for (std::size_t i = 0; i < first.sightings.size(); ++i)
    EXPECT_EQ(first.sightings[i].node, second.sightings[i].node);
}

/// What the sensors of known configurations meet is reachable, whatever else is found.
TEST(ArmReach, WhatARunFeltCounts) {
  ArmWorld before(plate_and_cube(), testing::thesis_arm_at({-3, -1, 0}));
  const ArmReachability found = before.look(40);
  PlacedArm arm = before.arm;
  std::vector<SurfaceSample> felt;
  for (std::size_t i = 0; i < found.reachability.samples.size(); ++i) {
    if (found.reachability.verdicts[i] != Verdict::yes) continue;
    felt.push_back(found.reachability.samples[i]);
    const std::vector<Configuration> way = before.reach->roadmap().way_to(found.sightings[i].node);
    arm.known.insert(arm.known.end(), way.begin(), way.end());
    arm.known.insert(arm.known.end(), way.rbegin(), way.rend());
  }
  ASSERT_GT(felt.size(), 20u);
  ArmWorld after(before.mesh, arm, 2);
  for (const Verdict verdict : after.reach->of(felt, 0.5).reachability.verdicts)
    EXPECT_EQ(verdict, Verdict::yes);
}

TEST(ArmReach, LooksOnlyForWhatIsAskedFor) {
  ArmWorld world(plate_and_cube(), testing::thesis_arm_at({-3, -1, 0}));
  auto [samples, spacing] = about(20, world.mesh);
  const std::vector<char> none(samples.size(), 0);
  for (const Verdict verdict : world.reach->of(samples, spacing, none).reachability.verdicts)
    EXPECT_EQ(verdict, Verdict::doubtful);
}

/// It counts from 0 to the whole, which goes with what is asked for, and changes nothing.
TEST(ArmReach, TellsHowFarItIs) {
  ArmWorld told(plate_and_cube(), testing::thesis_arm_at({-3, -1, 0}));
  ArmWorld silent(plate_and_cube(), testing::thesis_arm_at({-3, -1, 0}));
  auto [samples, spacing] = about(40, told.mesh);
  std::vector<char> asked(samples.size(), 0);
  std::fill_n(asked.begin(), 10, char{1});
  std::int64_t next = 0, last_whole = 0;
  const auto progress = [&](std::int64_t done, std::int64_t whole) {
    EXPECT_EQ(done, next++);
    EXPECT_LT(done, whole);
    EXPECT_TRUE(last_whole == 0 || whole == last_whole);
    last_whole = whole;
  };
  const ArmReachability found = told.reach->of(samples, spacing, asked, progress);
  EXPECT_EQ(next, last_whole);
  EXPECT_EQ(last_whole % 10, 0);
  EXPECT_GT(last_whole, 0);
  EXPECT_EQ(found.reachability.verdicts, silent.reach->of(samples, spacing, asked).reachability.verdicts);
}

TEST(ArmReach, RefusesWhatIsOutOfRange) {
  const simulation::Mesh mesh = testing::cube();
  const TrueSurface truth(mesh);
  const PlacedArm arm = testing::thesis_arm_at({-3, -1, 0});
  const auto with = [&](auto change) {
    PlacedArm other = arm;
    ArmSearchOptions options;
    options.resolution = options.control_clearance = kArmResolution;
    change(other, options);
    return ArmReach(mesh, truth, other, options);
  };
  EXPECT_THROW(with([](auto&, auto& o) { o.resolution = 0; }), std::invalid_argument);
  EXPECT_THROW(with([](auto&, auto& o) { o.control_clearance = 0; }), std::invalid_argument);
  EXPECT_THROW(with([](auto&, auto& o) { o.link_clearance = -1; }), std::invalid_argument);
  EXPECT_THROW(with([](auto& a, auto&) { a.robot.sensors.clear(); }), std::invalid_argument);
  EXPECT_THROW(with([](auto& a, auto&) { a.start = joints({0}); }), std::invalid_argument);
}

TEST(About, TakesNoMoreSamplesThanTwiceWhatIsAsked) {
  const simulation::Mesh sphere = simulation::make_shape("sphere:32");
  double area = 0;
  for (const simulation::Face& face : simulation::faces_of(sphere)) area += face.area;
  for (const std::size_t count : {1u, 50u, 3000u}) {
    const auto [samples, spacing] = about(count, sphere);
    EXPECT_LE(samples.size(), 2 * count);
    EXPECT_GE(samples.size(), count);
    double sum = 0;
    for (const SurfaceSample& sample : samples) sum += sample.area;
    EXPECT_NEAR(sum, area, area / static_cast<double>(count));
  }
}

}  // namespace
}  // namespace limpet::evaluation
