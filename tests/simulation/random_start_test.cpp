// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <cmath>
#include <limpet/simulation/random_start.hpp>
#include <limpet/simulation/ray_caster.hpp>
#include <limpet/simulation/shapes.hpp>

namespace limpet::simulation {
namespace {

using Eigen::Vector3d;

TEST(RandomStart, IsOutsideAtItsDistanceAndNoNearerToAnything) {
  for (const std::string name : {"cube", "L", "step_hole", "plate3", "octahedron", "room"}) {
    const Mesh mesh = make_shape(name);
    const RayCaster surface(mesh);
    const std::vector<Face> faces = faces_of(mesh);
    for (std::uint64_t seed = 0; seed < (name == "room" ? 4 : 50); ++seed) {
      const Vector3d start = random_start(mesh, 0.1, seed);
      EXPECT_NEAR(surface.distance(start), 0.1, 1e-6) << name << ", seed " << seed;
      int seen = 0;  // from outside
      for (const Face& face : faces) {
        const auto hit = surface.first_hit(start, -face.normal);
        seen += hit && std::abs(hit->range - 0.1) < 1e-6;
      }
      EXPECT_GE(seen, 1) << name << ", seed " << seed;
      EXPECT_EQ(start, random_start(mesh, 0.1, seed));
    }
    EXPECT_NE(random_start(mesh, 0.1, 1), random_start(mesh, 0.1, 2));
  }
}

TEST(RandomStart, IsUniformOverTheArea) {
  const Mesh plate = make_shape("thin_plate:0.25");  // two faces of 1, four of 0.25
  int on_large = 0;
  const int seeds = 1500;
  const Vector3d middle = bounds_of(plate).centre();
  for (int seed = 0; seed < seeds; ++seed) {
    const Vector3d start = random_start(plate, 0.01, static_cast<std::uint64_t>(seed)) - middle;
    on_large += std::abs(start.z()) > 0.125;
  }
  EXPECT_NEAR(on_large / static_cast<double>(seeds), 2.0 / 3, 0.05);
}

TEST(RandomStart, TakesOnlyWhatIsGoodAndGivesUp) {
  const Mesh cube = make_shape("cube");
  const double top = bounds_of(cube).high.z();
  const auto above = [top](const Vector3d& p) { return p.z() > top; };
  EXPECT_NEAR(random_start(cube, 0.1, 3, above).z(), top + 0.1, 1e-12);
  EXPECT_THROW(random_start(cube, 0.1, 3, [](const Vector3d&) { return false; }), MeshError);
  EXPECT_THROW(random_start(cube, 0, 3), MeshError);
  EXPECT_THROW(random_start(make_shape("room"), 6, 3), MeshError);  // 3 high
}

TEST(RandomRotation, IsARotationWithoutADirectionThatItLikes) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  double trace2 = 0;
  const int seeds = 4000;
  for (int seed = 0; seed < seeds; ++seed) {
    const Eigen::Matrix3d turn = random_rotation(static_cast<std::uint64_t>(seed)).toRotationMatrix();
    EXPECT_TRUE((turn * turn.transpose()).isIdentity(1e-12));
    EXPECT_NEAR(turn.determinant(), 1, 1e-12);
    sum += turn / seeds;
    trace2 += turn.trace() * turn.trace() / seeds;
  }
  EXPECT_LT(sum.cwiseAbs().maxCoeff(), 4 / std::sqrt(3.0 * seeds));
  EXPECT_NEAR(trace2, 1, 0.1);  // so it is for the uniform measure, whose characters are orthonormal
  EXPECT_TRUE(random_rotation(5).isApprox(random_rotation(5)));
}

}  // namespace
}  // namespace limpet::simulation
