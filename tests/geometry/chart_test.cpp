// Copyright the limpet authors. GPL-3.0-or-later.
#include <Eigen/Geometry>

#include <limpet/geometry/chart.hpp>

#include "perimeters.hpp"

namespace limpet::geometry {
namespace {

using Eigen::Vector3d;

Vector3d any_direction(Random& random) {
  for (;;) {
    const double x = 2 * random.unit() - 1, y = 2 * random.unit() - 1, z = 2 * random.unit() - 1;
    const Vector3d v(x, y, z);
    if (v.norm() > 0.1 && v.norm() < 1) return v.normalized();
  }
}

TEST(GridStep, IsTheSmallestPowerOfTwoNotBelow) {
  EXPECT_EQ(grid_step_for(4096), 1);
  EXPECT_EQ(grid_step_for(4097), 2);
  EXPECT_EQ(grid_step_for(2048), 0.5);
  for (const double length : {1e-9, 0.05, 0.0499, 3.0, 1e6}) {
    const double step = grid_step_for(length);
    EXPECT_EQ(std::exp2(std::round(std::log2(step))), step);
    EXPECT_GE(step, length / 4096);
    EXPECT_LT(step / 2, length / 4096);
  }
}

TEST(Chart, HasOrthonormalAxes) {
  Random random(51);
  for (int k = 0; k < 1000; ++k) {
    const Vector3d n = any_direction(random), hint = any_direction(random);
    if (std::abs(n.dot(hint)) > 0.99) continue;
    const Chart chart({Vector3d(1, 2, 3), n}, hint, 0.25);
    EXPECT_NEAR(chart.u().dot(chart.v()), 0, 1e-12);
    EXPECT_NEAR(chart.u().dot(n), 0, 1e-12);
    EXPECT_NEAR((chart.u().cross(chart.v()) - n).norm(), 0, 1e-12);
    EXPECT_NEAR(chart.u().norm(), 1, 1e-12);
    EXPECT_GT(chart.u().dot(hint), 0);
  }
}

TEST(Chart, ProjectionUndoesTheLift) {
  Random random(52);
  for (int k = 0; k < 1000; ++k) {
    const Vector3d n = any_direction(random), hint = any_direction(random);
    if (std::abs(n.dot(hint)) > 0.99) continue;
    const double step = 1.0 / 1024;
    const Chart chart({100 * any_direction(random), n}, hint, step);
    const Point2 p{static_cast<double>(random.whole(-100000, 100000)),
                   static_cast<double>(random.whole(-100000, 100000))};
    const double height = 1000 * random.unit();
    const Point2 q = chart.project(chart.at(p, height));
    EXPECT_NEAR(q.x, p.x, 1e-6);
    EXPECT_NEAR(q.y, p.y, 1e-6);
  }
}

TEST(Lift, PutsChartPointsOntoThePlane) {
  Random random(53);
  for (int k = 0; k < 1000; ++k) {
    const Vector3d n = any_direction(random), hint = any_direction(random);
    const Vector3d tilted = (n + 0.3 * any_direction(random)).normalized();
    if (std::abs(n.dot(hint)) > 0.99) continue;
    const Plane plane{3 * any_direction(random), tilted};
    const Chart chart({Vector3d(1, 2, 3), n}, hint, 0.125);
    const Lift lift(chart, plane);
    for (const Point2 p : {Point2{0, 0}, Point2{500, -20}, Point2{-3, 900}})
      EXPECT_NEAR(plane.height_of(chart.at(p, lift(p))), 0, 1e-9);
    const double cosine = tilted.dot(n);
    EXPECT_NEAR(lift.squared_tilt(), 1 / (cosine * cosine) - 1, 1e-9);
    const Plane back = lift.plane(chart);
    EXPECT_NEAR((back.normal - tilted).norm(), 0, 1e-9);
    EXPECT_NEAR(plane.height_of(back.point), 0, 1e-9);
  }
}

}  // namespace
}  // namespace limpet::geometry
