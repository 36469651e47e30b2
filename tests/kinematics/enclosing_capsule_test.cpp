// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/kinematics/enclosing_capsule.hpp>
#include <limpet/simulation/shapes.hpp>
#include <numbers>

#include "capsules.hpp"
#include "corners.hpp"
#include "robots.hpp"

namespace limpet::kinematics {
namespace {

using Eigen::Vector3d;
using model::Capsule;
using testing::excess;
using testing::is_in;

std::vector<Vector3d> cloud(survey::Random& random) {
  const Vector3d size(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 3));
  const Eigen::Isometry3d pose = testing::random_pose(random);
  std::vector<Vector3d> points;
  for (std::size_t i = 1 + random.below(60); i > 0; --i)
    points.emplace_back(pose * testing::random_vector(random, 1).cwiseProduct(size));
  return points;
}

TEST(EnclosingCapsule, HoldsItsPointsAndGoesBeyondThemByTwiceItsRadiusAtMost) {
  survey::Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const std::vector<Vector3d> points = cloud(random);
    const Capsule capsule = enclosing_capsule(points);
    for (const Vector3d& p : points) EXPECT_TRUE(is_in(p, capsule));
    EXPECT_LE(excess(capsule, points), 2 * capsule.radius + 1e-12);
  }
}

TEST(EnclosingCapsule, OfPointsOfACapsuleIsThatCapsule) {
  survey::Random random(2);
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::Isometry3d pose = testing::random_pose(random);
    const double radius = random.uniform(0.1, 0.3), length = random.uniform(0.5, 2);
    std::vector<Vector3d> points;
    for (int i = 0; i < 1000; ++i) {
      const Vector3d end(0, 0, i % 2 == 0 ? 0 : length);
      points.emplace_back(pose * (end + radius * testing::random_axis(random)));
    }
    const double true_volume = std::numbers::pi * radius * radius * (length + 4.0 / 3 * radius);
    EXPECT_LT(volume(enclosing_capsule(points)), 1.15 * true_volume);
  }
}

TEST(EnclosingCapsule, OfFewPoints) {
  const Vector3d p(1, 2, 3), q(1, 2, 5);
  EXPECT_LT((enclosing_capsule({p}).a - p).norm(), 1e-9);
  EXPECT_LT(enclosing_capsule({p}).radius, 1e-7);
  const Capsule line = enclosing_capsule({p, q, p});
  EXPECT_TRUE(is_in(p, line) && is_in(q, line));
  EXPECT_LT(line.radius, 1e-7);
}

TEST(EnclosingCapsules, HoldSurfaceAndInsideOfSolids) {
  survey::Random random(3);
  for (const std::string shape : {"cube", "L", "step_hole", "cross", "icosahedron"}) {
    const std::vector<Vector3d> corners = testing::corners_of(simulation::make_shape(shape));
    const std::vector<Capsule> parts = enclosing_capsules(corners);
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      for (int k = 0; k < 30; ++k) {
        double u = random.uniform(0, 1), v = random.uniform(0, 1);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const Vector3d p = corners[i] + u * (corners[i + 1] - corners[i]) + v * (corners[i + 2] - corners[i]);
        EXPECT_TRUE(testing::is_in_any(p, parts)) << shape;
      }
    }
  }
}

TEST(EnclosingCapsules, OfAThingThickAtOneEndAreSeveral) {
  // A pole on a block.
  std::vector<Vector3d> triangles;
  const auto add_box = [&](const Vector3d& low, const Vector3d& high) {
    const auto corner = [&](int i) {
      return Vector3d(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z());
    };
    for (const auto& [a, b, c] : {std::array{0, 1, 2},
                                  {1, 2, 3},
                                  {4, 5, 6},
                                  {5, 6, 7},
                                  {0, 1, 4},
                                  {1, 4, 5},
                                  {2, 3, 6},
                                  {3, 6, 7},
                                  {0, 2, 4},
                                  {2, 4, 6},
                                  {1, 3, 5},
                                  {3, 5, 7}})
      for (const int i : {a, b, c}) triangles.push_back(corner(i));
  };
  add_box(Vector3d(-0.5, -0.5, -0.6), Vector3d(0.5, 0.5, 0));
  add_box(Vector3d(-0.05, -0.05, 0), Vector3d(0.05, 0.05, 3));
  const std::vector<Capsule> parts = enclosing_capsules(triangles);
  EXPECT_GE(parts.size(), 2u);
  for (const Vector3d& corner : triangles) EXPECT_TRUE(testing::is_in_any(corner, parts));
  double sum = 0;
  for (const Capsule& part : parts) sum += volume(part);
  EXPECT_LT(sum, 0.75 * volume(enclosing_capsule(triangles)));
}

TEST(EnclosingCapsules, OfOneSizeAreOne) {
  EXPECT_EQ(enclosing_capsules(testing::corners_of(simulation::make_shape("cube"))).size(), 1u);
}

TEST(WithoutCovered, LeavesOutWhatIsInsideAnother) {
  const Capsule rod{Vector3d(0, 0, 0), Vector3d(0, 0, 1), 0.1};
  const Capsule end{Vector3d(0, 0, 1), Vector3d(0, 0, 1), 0.1}, knob{rod.a, rod.a, 0.2};
  EXPECT_TRUE(covers(rod, end));
  EXPECT_FALSE(covers(end, rod));
  EXPECT_EQ(without_covered({end, rod, rod, knob, end}).size(), 2u);
  EXPECT_EQ(without_covered({end, end}).size(), 1u);
  EXPECT_TRUE(without_covered({}).empty());
}

}  // namespace
}  // namespace limpet::kinematics
