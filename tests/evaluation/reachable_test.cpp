// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "random_places.hpp"
#include "run_worlds.hpp"

namespace limpet::evaluation {
namespace {

using Eigen::Vector3d;
using testing::kClearance;
using testing::kFollowDistance;
using testing::kRange;
using testing::kResolution;
using testing::RunWorld;

// ---- Free space --------------------------------------------------------------------------------

TEST(FreeSpace, HoldsWhatKeepsTheClearanceAndIsConnected) {
  const RunWorld world(testing::hollow());
  EXPECT_EQ(world.space->holds({1, 1, 2.25}), Verdict::yes);
  EXPECT_EQ(world.space->holds({1, 1, 2 + kClearance + 1e-9}), Verdict::yes);
  EXPECT_EQ(world.space->holds({1, 1, 2 + kClearance - 1e-9}), Verdict::no);
  EXPECT_EQ(world.space->holds({0.25, 0.25, 0.25}), Verdict::no);  // in the solid
  EXPECT_EQ(world.space->holds({1, 1, 1}), Verdict::no);           // in the hollow
  EXPECT_EQ(world.space->holds({50, 50, 50}), Verdict::yes);
  const RunWorld within(testing::hollow(), {1, 1, 1});
  EXPECT_EQ(within.space->holds({1.375, 1.375, 1.375}), Verdict::yes);
  EXPECT_EQ(within.space->holds({1, 1, 2.25}), Verdict::no);
}

TEST(FreeSpace, AFinerLatticeNeverContradicts) {
  for (const simulation::Mesh& mesh : {testing::slotted(0.21875, 0.75), testing::slotted(0.1875, 0.75)}) {
    const RunWorld coarse(mesh, {-1, -1, -1}, 0.0625), fine(mesh, {-1, -1, -1}, 0.02);
    survey::Random random(11);
    int doubtful_coarse = 0, doubtful_fine = 0;
    for (int i = 0; i < 2000; ++i) {
      Vector3d place = anywhere(random, -0.3, 1.3);
      if (i % 2 == 0) place.x() = 0.5 + 0.01 * (place.x() - 0.5);  // in the middle of the slot
      const Verdict a = coarse.space->holds(place), b = fine.space->holds(place);
      EXPECT_FALSE((a == Verdict::yes && b == Verdict::no) || (a == Verdict::no && b == Verdict::yes));
      if (a != Verdict::no) {
        EXPECT_GE(coarse.surface->distance(place), kClearance);
      }
      doubtful_coarse += a == Verdict::doubtful;
      doubtful_fine += b == Verdict::doubtful;
    }
    EXPECT_LE(doubtful_fine, doubtful_coarse);
  }
}

TEST(FreeSpace, AStartTooNearTheSurfaceLeavesIt) {
  const RunWorld world(testing::cube(), {0.5, 0.5, 1.03});
  EXPECT_EQ(world.space->holds({0.5, 0.5, 1.03}), Verdict::no);
  EXPECT_EQ(world.space->holds({0.5, 0.5, -0.25}), Verdict::yes);
  const RunWorld far(testing::cube(), {1000, -2000, 500});
  EXPECT_EQ(far.space->holds({0.5, 0.5, 1.25}), Verdict::yes);
}

TEST(FreeSpace, WaysKeepTheClearance) {
  const RunWorld world(simulation::make_shape("step_hole"));
  survey::Random random(5);
  int around = 0;
  for (int i = 0; i < 60; ++i) {
    const Vector3d a = anywhere(random, -0.3, 2.2), b = anywhere(random, -0.3, 2.2);
    if (world.space->holds(a) != Verdict::yes || world.space->holds(b) != Verdict::yes) continue;
    const std::vector<Vector3d> way = world.space->way(a, b);
    ASSERT_GE(way.size(), 2u);
    EXPECT_EQ(way.front(), a);
    EXPECT_EQ(way.back(), b);
    EXPECT_GE(length_of(way), (b - a).norm() - 1e-12);
    for (std::size_t k = 0; k + 1 < way.size(); ++k)
      EXPECT_GE(world.surface->distance_along(way[k], way[k + 1]), kClearance);
    around += way.size() > 2;
  }
  EXPECT_GT(around, 3);
}

TEST(FreeSpace, AWayRoundAPlateIsLittleLongerThanTheShortest) {
  const RunWorld world(simulation::make_shape("thin_plate:0.0625"));
  const double length = length_of(world.space->way({0.5, 0.5, 0.25}, {0.5, 0.5, -0.1875}));
  EXPECT_GE(length, 1.2);  // 0.5 out, round the rim at some distance, and 0.5 back
  EXPECT_LE(length, 1.6);
}

TEST(FreeSpace, PlacesAtADistanceAreThere) {
  const RunWorld world(testing::cube());
  const std::vector<Vector3d> places = world.space->places_at(0.2);
  const double pitch = world.space->pitch();
  for (const Vector3d& place : places) EXPECT_NEAR(world.surface->distance(place), 0.2, pitch / 2 + 1e-12);
  // The shell around a cube: six faces, twelve quarters of a cylinder, a sphere.
  const double pi = 3.14159265358979, area = 6 + 3 * 2 * pi * 0.2 + 4 * pi * 0.04;
  EXPECT_NEAR(static_cast<double>(places.size()), area / (pitch * pitch), 0.25 * area / (pitch * pitch));
}

TEST(FreeSpace, RefusesWhatIsOutOfRange) {
  const TrueSurface surface(testing::cube());
  const simulation::Bounds bounds = simulation::bounds_of(testing::cube());
  const auto make = [&](double clearance, double margin, double pitch) {
    return FreeSpace(surface, bounds, {{2, 2, 2}, clearance, margin, pitch});
  };
  EXPECT_THROW(make(0, 0.4, 0), std::invalid_argument);
  EXPECT_THROW(make(0.1, -1, 0), std::invalid_argument);
  EXPECT_THROW(make(0.1, 0.4, 0.08), std::invalid_argument);
  EXPECT_THROW(make(0.1, 0.4, 1e-5), std::invalid_argument);
  EXPECT_NO_THROW(make(0.1, 0.4, 0.0625));
}

// ---- Samples and sensors -----------------------------------------------------------------------

TEST(SurfaceSamples, StandForTheArea) {
  for (const char* shape : {"cube", "plate3", "octahedron", "room:2"}) {
    const simulation::Mesh mesh = simulation::make_shape(shape);
    const TrueSurface surface(mesh);
    const auto faces = simulation::faces_of(mesh);
    std::vector<double> areas(faces.size(), 0);
    for (const SurfaceSample& sample : samples_of(mesh, 0.2)) {
      areas[static_cast<std::size_t>(sample.face)] += sample.area;
      EXPECT_LE(surface.distance(sample.at), 1e-12);
      EXPECT_EQ(sample.normal, faces[static_cast<std::size_t>(sample.face)].normal);
    }
    for (std::size_t f = 0; f < faces.size(); ++f) EXPECT_NEAR(areas[f], faces[f].area, 1e-9);
  }
}

TEST(Sensing, IsThatOfThePointRobot) {
  const Sensing sensing = testing::point_robot_sensing();
  EXPECT_EQ(sensing.axes.size(), 26u);
  EXPECT_EQ(sensing.range, kRange);
  kinematics::Robot robot = kinematics::point_robot({});
  robot.sensors[3].position.x() = 0.1;
  EXPECT_THROW(sensing_of(kinematics::Posture(robot, Vector3d(0, 0, 0))), std::invalid_argument);
  robot = kinematics::point_robot({});
  robot.sensors[3].range = 1;
  EXPECT_THROW(sensing_of(kinematics::Posture(robot, Vector3d(0, 0, 0))), std::invalid_argument);
  robot.sensors.clear();
  EXPECT_THROW(sensing_of(kinematics::Posture(robot, Vector3d(0, 0, 0))), std::invalid_argument);
}

// ---- What is reachable -------------------------------------------------------------------------

TEST(Reachable, IsAllOfASimpleSolid) {
  for (const char* shape : {"cube", "L", "octahedron", "pyramid"}) {
    const Reachability found = RunWorld(simulation::make_shape(shape)).reachable();
    EXPECT_EQ(found.share, 1) << shape;
    EXPECT_EQ(found.doubtful, 0) << shape;
    for (const Reachability::Face& face : found.faces) EXPECT_EQ(face.share, 1) << shape;
  }
}

TEST(Reachable, AReachableSampleIsSeenFromWhereItIsSaid) {
  const RunWorld world(testing::slotted(0.25, 0.75));
  const Sensing sensing = testing::point_robot_sensing();
  const Reachability found = world.reachable(sensing);
  for (std::size_t i = 0; i < found.samples.size(); ++i) {
    if (found.verdicts[i] != Verdict::yes) continue;
    const Vector3d sight = found.samples[i].at - found.seen_from[i];
    const double range = sight.norm();
    EXPECT_LE(range, kRange + 1e-9);
    EXPECT_LT(sight.dot(found.samples[i].normal), 0);
    EXPECT_EQ(world.space->holds(found.seen_from[i]), Verdict::yes);
    EXPECT_NEAR(world.surface->first_crossing(found.seen_from[i], sight / range).value(), range, 1e-6);
    double along = -1;
    for (const Vector3d& axis : sensing.axes) along = std::max(along, axis.dot(sight) / range);
    EXPECT_NEAR(along, 1, 1e-12);
  }
}

TEST(Reachable, IsNotWhatIsOnlySeenAtGrazingIncidence) {
  // A single axis, inclined by so much, sees the top of a cube from beside it.
  const auto share_of_top = [](double incidence_deg, double least_cosine) {
    const double incidence = incidence_deg * std::numbers::pi / 180;
    Sensing sensing{{Vector3d(-std::sin(incidence), 0, -std::cos(incidence))}, kRange};
    if (least_cosine > 0) sensing.least_cosine = least_cosine;
    const RunWorld world(testing::cube());
    const int top = testing::face_at(world.mesh, Vector3d::UnitZ(), {0.5, 0.5, 1});
    return world.reachable(sensing).faces[static_cast<std::size_t>(top)].share;
  };
  EXPECT_GT(share_of_top(80, 0), 0.2);
  EXPECT_GT(share_of_top(84, 0), 0.2);
  EXPECT_EQ(share_of_top(86, 0), 0);
  EXPECT_GT(share_of_top(86, 0.01), 0.2);
}

TEST(Reachable, IsNotTheInsideOfANarrowSlot) {
  const simulation::Mesh mesh = testing::slotted(0.1875, 0.75);  // narrower than twice the clearance
  const Reachability found = RunWorld(mesh).reachable();
  const auto floor = static_cast<std::size_t>(testing::face_at(mesh, Vector3d::UnitZ(), {0.5, 0.5, 0.25}));
  EXPECT_LT(found.faces[floor].share, 0.8);  // from the ends of the slot
  EXPECT_LT(found.share, 1);
  for (std::size_t i = 0; i < found.samples.size(); ++i) {
    const Vector3d& at = found.samples[i].at;
    const bool outside =
        at.z() >= 1 || at.z() <= 0 || at.y() <= 0 || at.y() >= 1 || at.x() <= 0 || at.x() >= 1;
    if (outside) {
      EXPECT_EQ(found.verdicts[i], Verdict::yes);
    }
    const double depth = std::min({1 - at.z(), at.y(), 1 - at.y()});  // from the slot's three mouths
    if (!outside && depth > kRange) {
      EXPECT_EQ(found.verdicts[i], Verdict::no);
    }
  }
}

TEST(Reachable, IsTheInsideOfAWideSlot) {
  const Reachability found = RunWorld(testing::slotted(0.375, 0.75)).reachable();
  EXPECT_EQ(found.share, 1);
}

TEST(Reachable, ASlotTooNarrowForTheLatticeIsNotRuledOut) {
  const simulation::Mesh mesh = testing::slotted(0.203125, 0.75);  // 0.003 wider than twice the clearance
  const Reachability found = RunWorld(mesh).reachable();
  std::size_t inside = 0;
  for (std::size_t i = 0; i < found.samples.size(); ++i) {
    const Vector3d& at = found.samples[i].at;
    if (std::abs(at.x() - 0.5) > 0.11 || at.z() > 1 || at.z() < 0.25 + kFollowDistance) continue;
    EXPECT_NE(found.verdicts[i], Verdict::no);  // but for the bottom, where few axes lead
    ++inside;
  }
  EXPECT_GT(inside, 1000u);
}

TEST(Reachable, IsOnlyWhatIsConnectedToTheStart) {
  const simulation::Mesh mesh = testing::hollow();
  const Reachability outside = RunWorld(mesh).reachable();
  EXPECT_NEAR(outside.share, 24.0 / 30, 1e-9);
  EXPECT_EQ(outside.doubtful, 0);
  const Reachability inside = RunWorld(mesh, {1, 1, 1}).reachable();
  EXPECT_NEAR(inside.share, 6.0 / 30, 1e-9);
}

TEST(Reachable, AnAxisReachesOnlyTheFacesThatItMeets) {
  const RunWorld world(testing::cube());
  EXPECT_NEAR(world.reachable({{Vector3d::UnitX()}, kRange}).share, 1.0 / 6, 1e-9);
  EXPECT_NEAR(world.reachable({{Vector3d::UnitX(), -Vector3d::UnitX()}, kRange}).share, 2.0 / 6, 1e-9);
  EXPECT_NEAR(world.reachable({{Vector3d(1, 1, 1).normalized()}, kRange}).share, 3.0 / 6, 1e-9);
  // It cannot stand as near as it would have to.
  EXPECT_EQ(world.reachable({{Vector3d::UnitX()}, kClearance - 1e-6}).share, 0);
  EXPECT_NEAR(world.reachable({{Vector3d::UnitX()}, kClearance + 1e-6}).share, 1.0 / 6, 1e-9);
  // At 45°, too, but beside an edge: 0.099 before the face, and 0.015 or more before the edge.
  const Reachability aslant = world.reachable({{Vector3d(1, 1, 0).normalized()}, 1.4 * kClearance});
  const int face = testing::face_at(world.mesh, -Vector3d::UnitX(), {0, 0.5, 0.5});
  EXPECT_NEAR(aslant.faces.at(static_cast<std::size_t>(face)).share, 0.085, 0.005);
}

TEST(Reachable, TurnsWithTheWorld) {
  const simulation::Mesh mesh = testing::slotted(0.1875, 0.75);
  simulation::Mesh turned = mesh;
  const Eigen::Quaterniond turn = Eigen::Quaterniond(0.8, -0.3, 0.4, 0.2).normalized();
  for (Vector3d& vertex : turned.vertices) vertex = turn * vertex;
  const Sensing sensing = testing::point_robot_sensing();
  Sensing turned_sensing = sensing;
  for (Vector3d& axis : turned_sensing.axes) axis = turn * axis;
  const Vector3d start(-0.3, -0.3, -0.3);
  const Reachability a = RunWorld(mesh, start).reachable(sensing);
  const Reachability b = RunWorld(turned, turn * start).reachable(turned_sensing);
  for (std::size_t f = 0; f < a.faces.size(); ++f) {
    EXPECT_NEAR(a.faces[f].area, b.faces[f].area, 1e-9);
    EXPECT_NEAR(a.faces[f].share, b.faces[f].share, 0.01 + a.faces[f].doubtful + b.faces[f].doubtful);
  }
}

TEST(Reachable, GrowsWithTheRange) {
  const RunWorld world(testing::slotted(0.1875, 0.75));
  Sensing sensing = testing::point_robot_sensing();
  double before = 0;
  for (const double range : {0.12, 0.2, 0.3, 0.4}) {
    sensing.range = range;
    const double share = world.reachable(sensing).share;
    EXPECT_GE(share, before);
    before = share;
  }
  EXPECT_GT(before, 0.5);
}

}  // namespace
}  // namespace limpet::evaluation
