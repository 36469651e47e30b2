// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <cmath>
#include <limpet/evaluation/clearance.hpp>

#include "random_places.hpp"
#include "run_worlds.hpp"

namespace limpet::evaluation {
namespace {

using Eigen::Vector3d;
using survey::Random;

/// The smallest distance at places along a way: never less than the true one, and at most half a step more.
double sampled(const TrueSurface& surface, const Vector3d& a, const Vector3d& b, int steps) {
  double least = surface.distance(a);
  for (int i = 1; i <= steps; ++i)
    least = std::min(least, surface.distance(a + (b - a) * (static_cast<double>(i) / steps)));
  return least;
}

TEST(TrueSurface, DistanceAlongAWayIsTheSmallestOnIt) {
  for (const char* shape : {"cube", "L", "step_hole", "octahedron", "open_box"}) {
    const TrueSurface surface(simulation::make_shape(shape));
    Random random(7);
    for (int i = 0; i < 200; ++i) {
      const Vector3d a = anywhere(random, -0.5, 1.5), b = a + anywhere(random, -0.5, 0.5);
      const double along = surface.distance_along(a, b), at_places = sampled(surface, a, b, 100);
      EXPECT_LE(along, at_places + 1e-12) << shape;
      EXPECT_GE(along, at_places - (b - a).norm() / 200 - 1e-12) << shape;
      EXPECT_NEAR(along, surface.distance_along(b, a), 1e-13) << shape;
      for (const double least : {0.9 * along, 1.1 * along, 0.05})
        if (least > 0) {
          EXPECT_EQ(surface.keeps(a, b, least), along >= least) << shape;
        }
    }
  }
}

TEST(TrueSurface, MeetsIsDistanceZero) {
  const TrueSurface surface(testing::cube());
  EXPECT_TRUE(surface.meets({0.5, 0.5, 2}, {0.5, 0.5, 0.5}));     // through the top
  EXPECT_TRUE(surface.meets({0.5, 0.5, 2}, {0.5, 0.5, 1}));       // ends on it
  EXPECT_TRUE(surface.meets({-1, 0.5, 1}, {2, 0.5, 1}));          // within its plane
  EXPECT_TRUE(surface.meets({-0.5, 0.5, 0.5}, {0.5, 0.5, 1.5}));  // touches an edge
  EXPECT_TRUE(surface.meets({0, 0, 0}, {0, 0, 0}));               // stands on a corner
  EXPECT_FALSE(surface.meets({-1, 0.5, 1 + 1e-15}, {2, 0.5, 1 + 1e-15}));
  EXPECT_FALSE(surface.meets({0.25, 0.25, 0.25}, {0.75, 0.75, 0.75}));  // inside
  EXPECT_FALSE(surface.meets({2, 2, 2}, {2, 2, 2}));
}

TEST(TrueSurface, RaysMeetBothSides) {
  const TrueSurface surface(testing::cube());
  EXPECT_NEAR(surface.first_crossing({0.25, 0.5, 3}, -Vector3d::UnitZ()).value(), 2, 1e-12);
  EXPECT_NEAR(surface.first_crossing({0.25, 0.5, 0.25}, Vector3d::UnitZ()).value(), 0.75, 1e-12);
  EXPECT_FALSE(surface.first_crossing({0.25, 0.5, 3}, Vector3d::UnitZ()).has_value());
  EXPECT_NEAR(surface.first_crossing({-1, 0.5, 1}, Vector3d::UnitX()).value(), 1, 1e-12);  // within the top
}

TEST(TrueSurface, OfNothingIsNowhere) {
  const TrueSurface surface{simulation::Mesh{}};
  EXPECT_EQ(surface.distance({0, 0, 0}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(surface.distance_along({0, 0, 0}, {1, 0, 0}), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(surface.keeps({0, 0, 0}, {1, 0, 0}, 1));
  EXPECT_FALSE(surface.meets({0, 0, 0}, {1, 0, 0}));
  EXPECT_FALSE(surface.first_crossing({0, 0, 0}, Vector3d::UnitX()).has_value());
}

TEST(Clearance, OfALineOverACube) {
  const TrueSurface surface(testing::cube());
  const std::vector<Vector3d> path{{-2, 0.5, 1.25}, {-1, 0.5, 1.25}, {2, 0.5, 1.25}, {2, 0.5, 3}};
  const PathClearance found = clearance_of(path, surface);
  EXPECT_NEAR(found.at_positions, std::hypot(1, 0.25), 1e-12);
  EXPECT_NEAR(found.along, 0.25, 1e-12);
  EXPECT_EQ(found.worst, 1u);
  EXPECT_EQ(found.collisions, 0u);
  EXPECT_NEAR(found.length, 1 + 3 + 1.75, 1e-12);
}

TEST(Clearance, PastAnEdgeIsThatOfTheEdge) {
  const TrueSurface surface(testing::cube());
  // At right angles to the edge x = 0, z = 1, and 0.1 from it.
  const Vector3d out = Vector3d(-1, 0, 1).normalized(), across = Vector3d(1, 0, 1).normalized();
  const Vector3d nearest = Vector3d(0, 0.5, 1) + 0.1 * out;
  const std::vector<Vector3d> path{nearest - 0.7 * across, nearest + 0.3 * across};
  EXPECT_NEAR(clearance_of(path, surface).along, 0.1, 1e-12);
}

TEST(Clearance, AWayThroughAFaceIsACollision) {
  const TrueSurface surface(testing::cube());
  const std::vector<Vector3d> through{{0.5, 0.5, 1.5}, {0.5, 0.5, 1.25}, {0.5, 0.5, 0.5}, {0.5, 0.5, 0.4}};
  const PathClearance found = clearance_of(through, surface);
  EXPECT_EQ(found.collisions, 1u);  // the last step stays inside
  EXPECT_EQ(found.along, 0);
  EXPECT_EQ(found.worst, 1u);
  EXPECT_NEAR(found.at_positions, 0.25, 1e-12);
  const std::vector<Vector3d> touching{{0.5, 0.5, 1.5}, {0.5, 0.5, 1}, {0.5, 0.5, 1.5}};
  EXPECT_EQ(clearance_of(touching, surface).collisions, 2u);
  const std::vector<Vector3d> right_through{{0.5, 0.5, 1.5}, {0.5, 0.5, -0.5}};
  EXPECT_EQ(clearance_of(right_through, surface).collisions, 1u);
}

TEST(Clearance, AlongAPathIsNeverMoreThanAtItsPositions) {
  const TrueSurface surface(simulation::make_shape("step_hole"));
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    std::vector<Vector3d> path;
    for (int k = 0; k < 6; ++k) path.push_back(anywhere(random, -0.5, 2));
    const PathClearance found = clearance_of(path, surface);
    EXPECT_LE(found.along, found.at_positions);
    EXPECT_EQ(found.collisions > 0, found.along == 0);
    EXPECT_EQ(found.along, surface.distance_along(path[found.worst], path[found.worst + 1]));
    // A part of a path is no nearer.
    EXPECT_GE(clearance_of(std::span(path).first(3), surface).along, found.along);
  }
}

TEST(Clearance, OfFewPositions) {
  const TrueSurface surface(testing::cube());
  EXPECT_EQ(clearance_of({}, surface).along, std::numeric_limits<double>::infinity());
  const std::vector<Vector3d> one{{0.5, 0.5, 1.5}};
  EXPECT_EQ(clearance_of(one, surface).along, 0.5);
  EXPECT_EQ(clearance_of(one, surface).collisions, 0u);
  const std::vector<Vector3d> still{{0.5, 0.5, 1.5}, {0.5, 0.5, 1.5}};
  EXPECT_EQ(clearance_of(still, surface).along, 0.5);
}

}  // namespace
}  // namespace limpet::evaluation
