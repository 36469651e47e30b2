// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <fstream>
#include <limpet/io/error.hpp>
#include <limpet/simulation/random_start.hpp>
#include <limpet/simulation/range_image.hpp>
#include <limpet/simulation/ray_caster.hpp>
#include <limpet/simulation/shapes.hpp>
#include <limpet/simulation/world_description.hpp>
#include <numbers>

#include "../temporary_folder.hpp"

namespace limpet::simulation {
namespace {

using Eigen::Vector3d;

class WorldDescriptionTest : public limpet::testing::TemporaryFolder {};

TEST(Placement, ScalesThenTurnsThenMoves) {
  Placement placement;
  placement.scale = 2;
  placement.turn.euler_deg = Vector3d(0, 0, 90);
  placement.position = Vector3d(1, 0, 0);
  EXPECT_TRUE((transform_of(placement, 1) * Vector3d(1, 0, 0)).isApprox(Vector3d(1, 2, 0)));
}

TEST(Placement, EulerAnglesAreAboutFixedAxesInTheirOrder) {
  Turn turn;
  turn.euler_deg = Vector3d(90, 90, 0);  // z goes to -y about x, which turning about y leaves
  EXPECT_TRUE((rotation_of(turn, 1) * Vector3d::UnitZ()).isApprox(-Vector3d::UnitY()));
  EXPECT_TRUE((rotation_of(turn, 1) * Vector3d::UnitX()).isApprox(-Vector3d::UnitZ()));
}

TEST(Placement, QuaternionsAndSeedsTurn) {
  Turn turn;
  EXPECT_TRUE(rotation_of(turn, 7).isApprox(Eigen::Quaterniond::Identity()));
  turn.quaternion = Eigen::Vector4d(2, 0, 0, 2);
  EXPECT_TRUE((rotation_of(turn, 7) * Vector3d::UnitX()).isApprox(Vector3d::UnitY()));
  turn = Turn();
  turn.random = true;
  EXPECT_TRUE(rotation_of(turn, 7).isApprox(random_rotation(7)));
}

TEST(Placement, KeepsAMeshWhatItIs) {
  const Mesh mesh = make_shape("step_hole");
  Placement placement;
  placement.scale = 3;
  placement.turn.random = true;
  placement.position = Vector3d(5, 6, 7);
  const Mesh moved = placed(mesh, transform_of(placement, 3));
  EXPECT_EQ(moved.face_of_triangle, mesh.face_of_triangle);
  EXPECT_NEAR(signed_volume(moved), 27 * signed_volume(mesh), 1e-9);
}

TEST_F(WorldDescriptionTest, AMeshIsSeenWhereItIsPlaced) {
  WorldDescription wanted;
  wanted.mesh = "cube";
  wanted.placement.position = Vector3d(10, 0, 0);
  wanted.initial_faces = {1, 4};
  const BuiltWorld built = build_world(wanted, 1);
  ASSERT_TRUE(built.truth);
  const Bounds bounds = bounds_of(*built.truth);
  const Vector3d over = bounds.centre() + Vector3d(0, 0, 0.5 + 0.1);
  EXPECT_NEAR(built.world->sight(over, -Vector3d::UnitZ(), 1)->distance, 0.1, 1e-12);
  EXPECT_NEAR(bounds.low.x() - bounds_of(make_shape("cube")).low.x(), 10, 1e-12);
  EXPECT_EQ(built.initial.size(), 2u);
  EXPECT_TRUE(built.image.empty());
  EXPECT_EQ(random_start(built, 0.1, 4), random_start(*built.truth, 0.1, 4));
}

TEST_F(WorldDescriptionTest, ARangeImageOfAMeshTurnsWithIt) {
  WorldDescription wanted;
  wanted.mesh = "L";
  wanted.direction = Vector3d(-1, -2, -3);
  wanted.pitch = 0.02;
  wanted.initial_occluded = true;
  const BuiltWorld straight = build_world(wanted, 1);
  wanted.placement.turn.random = true;
  const BuiltWorld turned = build_world(wanted, 1);
  EXPECT_GE(straight.initial.size(), 3u);
  EXPECT_EQ(turned.initial.size(), straight.initial.size());
  EXPECT_NEAR(static_cast<double>(turned.image.size()) / static_cast<double>(straight.image.size()), 1, 0.02);
  const RayCaster surface(*turned.truth);
  for (const Vector3d& p : turned.image) ASSERT_LT(surface.distance(p), 1e-9);
}

TEST_F(WorldDescriptionTest, ARandomStartSeesThePartThatTheImageShows) {
  WorldDescription wanted;
  wanted.mesh = "cube";
  wanted.direction = Vector3d(0, 0, -1);
  wanted.pitch = 0.02;
  const BuiltWorld built = build_world(wanted, 1);
  const double top = bounds_of(*built.truth).high.z();
  for (std::uint64_t seed = 0; seed < 30; ++seed)
    EXPECT_NEAR(random_start(built, 0.1, seed).z(), top + 0.1, 1e-9);
}

TEST_F(WorldDescriptionTest, ARangeImageIsReadFromAScan) {
  std::ofstream(path("image.xyz")) << "0 0 0\n0 0.1 0\n0.1 0 0\n0.1 0.1 0\n";
  WorldDescription wanted;
  wanted.image = path("image.xyz");
  wanted.placement.scale = 2;
  wanted.placement.position = Vector3d(0, 0, 1);
  const BuiltWorld built = build_world(wanted, 1);
  EXPECT_FALSE(built.truth);
  ASSERT_EQ(built.image.size(), 4u);
  EXPECT_TRUE(built.image[3].isApprox(Vector3d(0.2, 0.2, 1)));
  const auto seen = built.world->sight(Vector3d(0, 0.05, 2), -Vector3d::UnitZ(), 5);
  ASSERT_TRUE(seen);  // within ε = 0.2
  EXPECT_EQ(seen->distance, 1);
  EXPECT_TRUE(build_world(wanted, 1).world->sight(Vector3d(0, 0, 0), Vector3d::UnitZ(), 5));
  wanted.direction = Vector3d(0, 0, -1);
  EXPECT_FALSE(build_world(wanted, 1).world->sight(Vector3d(0, 0, 0), Vector3d::UnitZ(), 5));
  wanted.two_sided = true;
  EXPECT_TRUE(build_world(wanted, 1).world->sight(Vector3d(0, 0, 0), Vector3d::UnitZ(), 5));
  wanted.epsilon = 0.01;
  EXPECT_FALSE(build_world(wanted, 1).world->sight(Vector3d(0, 0.05, 2), -Vector3d::UnitZ(), 5));
  EXPECT_THROW(random_start(built, 0.1, 1), MeshError);
}

TEST_F(WorldDescriptionTest, WhatIsNotThereIsRefused) {
  WorldDescription wanted;
  wanted.mesh = path("missing.off");
  EXPECT_THROW(build_world(wanted, 1), MeshError);
  wanted.mesh = "cube";
  wanted.initial_faces = {6};
  EXPECT_THROW(build_world(wanted, 1), MeshError);
  wanted.initial_faces.clear();
  wanted.initial_occluded = true;
  EXPECT_THROW(build_world(wanted, 1), MeshError);
  wanted.pitch = 0.1;
  EXPECT_THROW(build_world(wanted, 1), MeshError);  // and no direction
  wanted = WorldDescription();
  wanted.image = path("missing.xyz");
  EXPECT_THROW(build_world(wanted, 1), io::InputError);
  wanted.initial_faces = {0};
  EXPECT_THROW(build_world(wanted, 1), MeshError);
}

}  // namespace
}  // namespace limpet::simulation
