// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <limpet/simulation/shapes.hpp>
#include <limpet/simulation/world.hpp>
#include <limpet/survey/random.hpp>

namespace limpet::simulation {
namespace {

using Eigen::Vector3d;

TEST(MeshWorld, SeesTheFirstSurfaceWithinRangeFromOutside) {
  std::unique_ptr<World> world;
  {
    const Mesh cube = make_shape("cube");  // from 0 to 1
    world = make_mesh_world(cube);         // outlives it
  }
  const Vector3d above(0.5, 0.25, 1.125), down(0, 0, -1);
  const auto seen = world->sight(above, down, 0.125);
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->distance, 0.125);
  EXPECT_EQ(seen->incidence_cosine, 1);
  EXPECT_EQ(seen->aside, Vector3d::Zero());
  EXPECT_FALSE(world->sight(above, down, 0.1249));
  EXPECT_FALSE(world->sight(above, -down, 10));
  EXPECT_FALSE(world->sight(Vector3d(0.5, 0.25, 0.5), down, 10));  // from within
}

TEST(MeshWorld, KnowsTheAngleOfIncidence) {
  const auto world = make_mesh_world(make_shape("cube"));
  for (const double angle : {0.0, 0.3, 0.9, 1.4}) {
    const Vector3d axis(std::sin(angle), 0, -std::cos(angle));
    const auto seen = world->sight(Vector3d(0.1, 0.5, 1.1), axis, 2);
    ASSERT_TRUE(seen) << angle;
    EXPECT_NEAR(seen->incidence_cosine, std::cos(angle), 1e-12);
    EXPECT_NEAR(seen->distance, 0.1 / std::cos(angle), 1e-12);
  }
}

/// The distance of a place from a triangle: from its plane, if it is above it, else from its sides.
double distance_by_hand(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d normal = (b - a).cross(c - a).normalized();
  double least = std::numeric_limits<double>::infinity();
  bool is_above = true;
  for (const auto& [from, to] : {std::pair(a, b), {b, c}, {c, a}}) {
    const Vector3d side = to - from;
    is_above = is_above && normal.dot(side.cross(p - from)) >= 0;
    const double along = std::clamp(side.dot(p - from) / side.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (from + along * side - p).norm());
  }
  return is_above ? std::abs(normal.dot(p - a)) : least;
}

TEST(MeshWorld, ABallMeetsTheSurfaceWhereItIsNoFartherThanItsRadius) {
  survey::Random random(20261130);
  int met = 0, missed = 0;
  for (const char* shape : {"cube", "L", "open_box", "octahedron", "cells:5", "sphere:16"}) {
    const Mesh mesh = make_shape(shape);
    const auto world = make_mesh_world(mesh);
    const Bounds bounds = bounds_of(mesh);
    for (int trial = 0; trial < 300; ++trial) {
      Vector3d centre;
      for (int k = 0; k < 3; ++k) centre[k] = random.uniform(bounds.low[k] - 0.3, bounds.high[k] + 0.3);
      double distance = std::numeric_limits<double>::infinity();
      for (const auto& [a, b, c] : mesh.triangles)
        distance = std::min(distance,
                            distance_by_hand(centre, mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]));
      const double radius = random.uniform(0, 0.4);
      if (std::abs(radius - distance) < 1e-9) continue;
      EXPECT_EQ(world->meets(centre, radius), distance < radius)
          << shape << ": " << distance << ", " << radius;
      EXPECT_FALSE(world->meets(centre, distance - 1e-9));
      EXPECT_TRUE(world->meets(centre, distance + 1e-9));
      ++(distance < radius ? met : missed);
    }
  }
  EXPECT_GT(met, 300);
  EXPECT_GT(missed, 300);
}

}  // namespace
}  // namespace limpet::simulation
