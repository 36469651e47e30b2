// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <cmath>
#include <limpet/simulation/shapes.hpp>
#include <limpet/simulation/world.hpp>

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

}  // namespace
}  // namespace limpet::simulation
