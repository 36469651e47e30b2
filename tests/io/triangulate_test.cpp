// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <limpet/io/triangulate.hpp>
#include <random>

namespace limpet::io {
namespace {

using Cycle = std::vector<Eigen::Vector2d>;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

double area(const Cycle& cycle) {
  double twice = 0;
  for (std::size_t i = 0; i < cycle.size(); ++i) twice += cross(cycle[i], cycle[(i + 1) % cycle.size()]);
  return twice / 2;
}

/// Sum of the triangles' areas; fails when one is not anticlockwise.
double triangle_area(const std::vector<Cycle>& cycles) {
  Cycle points;
  for (const Cycle& cycle : cycles) points.insert(points.end(), cycle.begin(), cycle.end());
  double sum = 0;
  for (const auto& [a, b, c] : triangulate(cycles)) {
    const double twice = cross(points[b] - points[a], points[c] - points[a]);
    EXPECT_GT(twice, 0);
    sum += twice / 2;
  }
  return sum;
}

Cycle square(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}
Cycle turned(const Cycle& cycle) { return {cycle.rbegin(), cycle.rend()}; }

TEST(Triangulate, ASquareIsTwoTriangles) {
  EXPECT_EQ(triangulate({square(0, 0, 4)}).size(), 2u);
  EXPECT_EQ(triangle_area({square(0, 0, 4)}), 16);
}

TEST(Triangulate, HolesStayEmpty) {
  const std::vector<Cycle> cycles = {square(0, 0, 10), turned(square(1, 1, 2)), turned(square(5, 5, 3))};
  EXPECT_EQ(triangle_area(cycles), 100 - 4 - 9);
  EXPECT_EQ(triangulate(cycles).size(), 12u + 2 * 2 - 2);
  EXPECT_EQ(triangle_area({square(0, 0, 10), square(1, 1, 2), square(5, 5, 3)}), 100 - 4 - 9)
      << "the direction of a cycle does not matter";
}

TEST(Triangulate, AnIslandInAHoleIsFilled) {
  EXPECT_EQ(triangle_area({square(0, 0, 10), turned(square(1, 1, 8)), square(2, 2, 6)}), 100 - 64 + 36);
}

TEST(Triangulate, HolesMayTouchAtAVertex) {
  EXPECT_EQ(triangle_area({square(0, 0, 10), turned(square(1, 1, 2)), turned(square(3, 3, 2))}), 100 - 4 - 4);
}

TEST(Triangulate, StraightRunsOfVerticesAreKept) {
  const Cycle cycle = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 2}, {0, 1}};
  EXPECT_EQ(triangle_area({cycle}), 9);
  EXPECT_EQ(triangulate({cycle}).size(), cycle.size() - 2);
}

/// Star-shaped polygons around the origin on a grid, with a square hole in the middle.
TEST(Triangulate, AreaOfRandomStarsIsKept) {
  constexpr std::uint64_t kSeed = 31;
  RecordProperty("seed", std::to_string(kSeed));
  std::mt19937_64 random(kSeed);
  for (int round = 0; round < 50; ++round) {
    SCOPED_TRACE(round);
    const int count = 8 + round;
    Cycle star;
    for (int i = 0; i < count; ++i) {
      // A walk around a square gives directions in order without trigonometry.
      const double t = 8.0 * i / count;
      const Eigen::Vector2d direction = t < 2   ? Eigen::Vector2d(1, t - 1)
                                        : t < 4 ? Eigen::Vector2d(3 - t, 1)
                                        : t < 6 ? Eigen::Vector2d(-1, 5 - t)
                                                : Eigen::Vector2d(t - 7, -1);
      const double radius = 1000 + static_cast<double>(random() % 4000);
      star.push_back({std::floor(radius * direction.x()), std::floor(radius * direction.y())});
    }
    const std::vector<Cycle> cycles = {star, turned(square(-100, -100, 200))};
    EXPECT_EQ(triangle_area(cycles), area(star) - 40000);
  }
}

TEST(Triangulate, WhatBoundsNothingHasNoTriangles) {
  EXPECT_TRUE(triangulate({}).empty());
  EXPECT_TRUE(triangulate({{{0, 0}, {1, 1}}}).empty());
  EXPECT_TRUE(triangulate({{{0, 0}, {1, 1}, {2, 2}}}).empty());
  EXPECT_TRUE(triangulate({{{0, 0}, {1, 0}, {0, std::numeric_limits<double>::quiet_NaN()}}}).empty());
}

TEST(Triangulate, CrossingEdgesLeaveOutTheirTrianglesOnly) {
  // A bow tie next to a sound square: the square is kept whole.
  const Cycle bow = {{20, 0}, {24, 4}, {24, 0}, {20, 4}};
  const std::vector<Cycle> cycles = {square(0, 0, 4), bow};
  EXPECT_EQ(triangle_area(cycles), 16);
}

}  // namespace
}  // namespace limpet::io
