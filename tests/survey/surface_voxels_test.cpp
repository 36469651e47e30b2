// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limpet/survey/random.hpp>
#include <limpet/survey/surface_voxels.hpp>

namespace limpet::survey {
namespace {

TEST(SurfaceVoxels, PatchesOfAPlaneHaveItsNormal) {
  const std::uint64_t seed = 5;
  RecordProperty("seed", std::to_string(seed));
  Random random(seed);
  const Eigen::Vector3d normal = Eigen::Vector3d(1, -2, 3).normalized();
  const Eigen::Vector3d u = normal.cross(Eigen::Vector3d::UnitX()).normalized(), v = normal.cross(u);
  const Eigen::Vector3d far_away(1e5, -2e5, 3e5);
  SurfaceVoxels voxels(0.1);
  constexpr int kPoints = 20'000;  // twenty in a voxel
  for (int i = 0; i < kPoints; ++i) {
    voxels.add(far_away + (random.uniform() - 0.5) * 3 * u + (random.uniform() - 0.5) * 3 * v +
               0.002 * random.normal() * normal);
  }
  voxels.fit();
  EXPECT_LT(voxels.size(), 4000) << "memory goes with the surface";
  int flat = 0;
  for (int i = 0; i < voxels.size(); ++i) {
    const SurfacePatch& patch = voxels.patch(i);
    EXPECT_NEAR((patch.centroid - far_away).dot(normal), 0, 0.01);
    if (!patch.flat) continue;
    ++flat;
    EXPECT_GT(std::abs(patch.normal.dot(normal)), std::cos(0.2)) << "voxel " << i;
  }
  EXPECT_GT(flat, voxels.size() * 95 / 100);
}

TEST(SurfaceVoxels, AnEdgeIsNotFlatAndALineHasNoNormal) {
  SurfaceVoxels voxels(1);
  for (int i = 0; i < 2000; ++i) {
    const int row = i / 50;
    const double a = 0.05 * (i % 50), b = 0.1 * row;
    voxels.add({a, b, 0});
    voxels.add({0, b, a});
  }
  for (int i = 0; i < 100; ++i) voxels.add({100 + 0.1 * i, 50, 50});
  voxels.fit();
  const int at_edge = voxels.find_point({0, 2, 0}), on_face = voxels.find_point({2, 2, 0});
  ASSERT_GE(at_edge, 0);
  ASSERT_GE(on_face, 0);
  EXPECT_FALSE(voxels.patch(at_edge).flat);
  EXPECT_TRUE(voxels.patch(on_face).flat);
  EXPECT_NEAR(std::abs(voxels.patch(on_face).normal.z()), 1, 1e-9);
  EXPECT_FALSE(voxels.patch(voxels.find_point({105, 50, 50})).has_normal());
  EXPECT_EQ(voxels.find_point({50, 50, 50}), -1);
  EXPECT_EQ(voxels.find_point({1e12, 0, 0}), -1);
}

TEST(SurfaceVoxels, NumbersAreByPlace) {
  SurfaceVoxels voxels(1);
  for (const double x : {5.0, -3.0, 2.0, 9.0}) voxels.add({x, 0, 0});
  voxels.fit();
  for (int i = 1; i < voxels.size(); ++i) EXPECT_LT(voxels.key(i - 1), voxels.key(i));
  EXPECT_EQ(voxels.find(voxels.key(2)), 2);
}

}  // namespace
}  // namespace limpet::survey
