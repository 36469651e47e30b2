// Copyright the limpet authors. GPL-3.0-or-later.
//
// Scatter about planes and quadrics, and noise for facets of curved surfaces.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <limpet/survey/curved_patches.hpp>
#include <limpet/survey/random.hpp>

#include "estimates.hpp"
#include "simulated.hpp"

namespace limpet::survey {
namespace {

using Eigen::Vector3d;
using Height = std::function<double(double x, double y)>;

/// Points over the unit disc in a plane of any position, at these heights plus noise.
std::vector<Vector3d> patch(const Height& height, double noise, const Eigen::Isometry3d& pose, Random& random,
                            int count = 2000) {
  std::vector<Vector3d> points;
  while (static_cast<int>(points.size()) < count) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    if (x * x + y * y < 1) points.push_back(pose * Vector3d(x, y, height(x, y) + noise * random.normal()));
  }
  return points;
}

Eigen::Isometry3d any_pose(Random& random) {
  const Vector3d axis = Vector3d(random.normal(), random.normal(), random.normal()).normalized();
  return Eigen::Translation3d(random.uniform(-9, 9), 5, 1) * Eigen::AngleAxisd(random.uniform(0, 3), axis);
}

TEST(CurvedPatches, ACapScattersAboutItsPlaneAsItsSagittaSays) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto pose = any_pose(random);
    const double curvature = random.uniform(0.05, 0.2), noise = 0.1 * curvature;
    const auto cap =
        patch([&](double x, double y) { return 0.5 * curvature * (x * x + y * y); }, noise, pose, random);
    const auto scatter = patch_scatter(cap, pose.linear().col(2));
    ASSERT_TRUE(scatter);
    // Heights are uniform in [0, curvature/2] over the disc.
    const double expected = std::hypot(curvature / 2 / std::sqrt(12.0), noise);
    EXPECT_NEAR(scatter->plane / expected, 1, 0.06);
    EXPECT_NEAR(scatter->quadric / noise, 1, 0.06);
  }
}

TEST(CurvedPatches, ACreaseIsNoQuadric) {
  Random random(1);
  const auto pose = any_pose(random);
  const auto crease = patch([](double x, double) { return 0.2 * std::abs(x); }, 0.001, pose, random);
  const auto scatter = patch_scatter(crease, pose.linear().col(2));
  ASSERT_TRUE(scatter);
  EXPECT_GT(scatter->quadric, 10 * 0.001);
}

TEST(CurvedPatches, TooFewPointsSayNothing) {
  Random random(1);
  const auto pose = any_pose(random);
  const auto flat = [](double, double) { return 0.0; };
  EXPECT_FALSE(patch_scatter(patch(flat, 0, pose, random, 11), pose.linear().col(2)));
  EXPECT_TRUE(patch_scatter(patch(flat, 0, pose, random, 12), pose.linear().col(2)));
  EXPECT_FALSE(patch_scatter(std::vector<Vector3d>(20, Vector3d(1, 2, 3)), Vector3d::UnitZ()));
}

TEST(CurvedPatches, ASurfaceIsCurvedWhereHalfOfItsPatchesAre) {
  const double noise = 0.001;
  const auto wide = [&](int curved, int flat, int creased) {
    std::vector<WidePatch> all;
    for (int i = 0; i < curved; ++i) all.push_back({0.1, noise, {std::hypot(0.003, noise), noise}});
    for (int i = 0; i < flat; ++i) all.push_back({0.1, noise, {noise, noise}});
    for (int i = 0; i < creased; ++i) all.push_back({0.1, noise, {0.003, 1.5 * noise}});
    return all;
  };
  EXPECT_NEAR(surface_curvature(wide(60, 20, 20), 100), 4 * 0.003 / (0.1 * 0.1), 1e-9);
  for (const auto& not_curved : {wide(40, 60, 0), wide(0, 0, 100), wide(40, 0, 60), wide(0, 100, 0)})
    EXPECT_EQ(surface_curvature(not_curved, 100), 0);
}

/// A sphere's facets are to be some λ wide.
TEST(CurvedPatches, ASphereAsksForFacetsASlabDoesNot) {
  const auto estimate_of = [](const testing::SimulatedScan& scan) {
    const auto points = scan.make();
    return estimate([&](const Take& take) {
      for (const auto& p : points) take(p.point);
    });
  };
  using enum simulation::ScanOptions::Order;
  const double radius = 0.5;
  for (const std::int64_t points : {3'000, 10'000, 200'000}) {
    const Estimate sphere = estimate_of({"sphere", points, sampled, 0.0005, 0});
    const double lambda = suitable_resolution(sphere, sphere.noise).fixed,
                 turning = lambda * lambda / (radius * std::sqrt(3)),
                 noise = facet_noise(sphere, sphere.noise, lambda).fixed;
    EXPECT_NEAR(noise / std::hypot(0.0005, turning), 1, 0.25) << points;
    EXPECT_LE(noise, std::max(sphere.noise.fixed, lambda / 15));
  }
  EXPECT_EQ(estimate_of({"thin_plate:0.05", 10'000, sampled, 0.0005, 0}).curvature, 0);
  EXPECT_EQ(estimate_of({"city:25", 100'000, shuffled, 0.0005, 0.01}).curvature, 0);
}

}  // namespace
}  // namespace limpet::survey
