// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/following/transit/detour_internal.hpp>
#include <string>

#include "initial_model.hpp"
#include "random_places.hpp"

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;

constexpr double kSpacing = kLambda / 2;

/// Faces far below, and readings in the way.
struct Obstacles {
  model::Model model = initial_model({{rectangle(0, 0, 1, 1, -10)}});
  Clearance clearance{usual_parameters(kLambda).clearance()};

  void add(const std::vector<Vector3d>& places) {
    std::vector<model::SensorPoint> readings(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) readings[i].position = places[i];
    clearance.remember(readings);
  }
  std::vector<Vector3d> way(const Vector3d& from, const Vector3d& to) const {
    return detour(model.view(), clearance, from, to, kSpacing);
  }
  bool is_clear(const Vector3d& from, const Vector3d& to) const {
    return clearance.is_clear(model.view(), from, to);
  }
};

double length_of(const Vector3d& from, const std::vector<Vector3d>& way) {
  double length = 0;
  Vector3d before = from;
  for (const Vector3d& place : way) length += (place - std::exchange(before, place)).norm();
  return length;
}

/// Points of a plane x = 0, λ/2 apart, but for those for which is_left_out.
template <class F>
std::vector<Vector3d> screen(double half_width, F&& is_left_out) {
  std::vector<Vector3d> points;
  for (double y = -half_width; y <= half_width; y += kSpacing)
    for (double z = -half_width; z <= half_width; z += kSpacing)
      if (const Vector3d p(0, y, z); !is_left_out(p)) points.push_back(p);
  return points;
}

TEST(Detour, GoesStraightWhereNothingIsInTheWay) {
  const Obstacles none;
  const Vector3d to(3 * kLambda, kLambda, 0);
  ASSERT_EQ(none.way({0, 0, 0}, to).size(), 1U);
  EXPECT_EQ(none.way({0, 0, 0}, to).front(), to);
  const auto far = none.way({0, 0, 0}, {1, 0, 0});
  ASSERT_FALSE(far.empty());
  EXPECT_EQ(far.back(), Vector3d(1, 0, 0)) << "nothing is in the way there, either";
}

TEST(Detour, GoesThroughAGapInAScreen) {
  Obstacles obstacles;
  const Vector3d gap(0, 2.2 * kLambda, 0);
  obstacles.add(screen(0.5, [&](const Vector3d& p) { return (p - gap).norm() < 1.6 * kLambda; }));
  const Vector3d from(-1.5 * kLambda, 0, 0), to(1.5 * kLambda, 0, 0);
  const auto way = obstacles.way(from, to);
  ASSERT_FALSE(way.empty());
  EXPECT_EQ(way.back(), to);
  EXPECT_LT(length_of(from, way), 8 * kLambda);
}

TEST(Detour, FindsNoneOutOfACage) {
  Obstacles obstacles;
  std::vector<Vector3d> cage;
  for (double x = -2; x <= 2; x += 0.5)
    for (double y = -2; y <= 2; y += 0.5)
      for (double z = -2; z <= 2; z += 0.5)
        if (const Vector3d p(x, y, z); p.cwiseAbs().maxCoeff() == 2) cage.push_back(kLambda * p);
  obstacles.add(cage);
  EXPECT_TRUE(obstacles.way({0, 0, 0}, {4 * kLambda, 0, 0}).empty());
  EXPECT_TRUE(obstacles.way({0, 0, 0}, {1, 0, 0}).empty());
  EXPECT_FALSE(obstacles.way({0, 0, 0}, {0.5 * kLambda, 0, 0}).empty()) << "it may go about in it";
  EXPECT_TRUE(obstacles.way({0, 0, 0}, 2 * kLambda * Vector3d(1, 0, 0)).empty()) << "not clear";
}

TEST(Detour, IsClearAllAlongAmongRandomPoints) {
  int found = 0, round = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    survey::Random random(seed);
    Obstacles obstacles;
    std::vector<Vector3d> points(10 + random.below(60));
    for (Vector3d& p : points) p = random_place(random, 4 * kLambda);
    obstacles.add(points);
    const Vector3d from = random_place(random, 4 * kLambda);
    const Vector3d to = random_place(random, seed % 4 ? 4 * kLambda : 20 * kLambda);
    const auto way = obstacles.way(from, to);
    if (way.empty()) {
      ASSERT_FALSE(obstacles.is_clear(from, to));
      continue;
    }
    ++found, round += way.size() > 1;
    Vector3d before = from;
    for (const Vector3d& place : way) ASSERT_TRUE(obstacles.is_clear(std::exchange(before, place), place));
    const double left = (to - way.back()).norm();
    ASSERT_TRUE(left == 0 || left < (to - from).norm() - 6 * kSpacing);
    ASSERT_EQ(obstacles.way(from, to), way) << "the same again";
  }
  EXPECT_GT(found, 60);
  EXPECT_GT(round, 20);
}

}  // namespace
}  // namespace limpet::following::internal
