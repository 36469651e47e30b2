// Copyright the limpet authors. GPL-3.0-or-later.
#include <cmath>

#include <gtest/gtest.h>

#include <limpet/model/fit_internal.hpp>
#include <limpet/survey/random.hpp>

namespace limpet::model {
namespace {

using Eigen::Vector3d;
using survey::Random;

/// The lattice points (i, j, a·i + b·j), 0 ≤ i < width, 0 ≤ j < height, about `origin`.
Moments sloping_lattice(int width, int height, int a, int b, const GridPoint& origin) {
  Moments m;
  for (int i = 0; i < width; ++i)
    for (int j = 0; j < height; ++j) m.add({origin[0] + i, origin[1] + j, origin[2] + a * i + b * j});
  return m;
}

TEST(Fit, FindsThePlaneThatAllPointsLieIn) {
  for (const std::int64_t far : {std::int64_t{0}, std::int64_t{1'000'000'000'000}})
    for (int a = -3; a <= 3; ++a)
      for (int b = -3; b <= 3; ++b) {
        const Fit fit = fit_to(sloping_lattice(9, 7, a, b, {far, -far, far}), 0.5, {0, 0, -1});
        const Vector3d normal = Vector3d(-a, -b, 1).normalized();
        EXPECT_LT((fit.normal - normal).norm(), 1e-7) << a << ' ' << b << ' ' << far;
        EXPECT_LT(fit.u3, 1e-12 * fit.u1) << a << ' ' << b << ' ' << far;
        const auto f = static_cast<double>(far);
        EXPECT_EQ(fit.centroid, 0.5 * Vector3d(f + 4, 3 - f, f + 4 * a + 3 * b));
        EXPECT_EQ(fit.count, 63);
      }
}

TEST(Fit, EigenvaluesAreTheVariancesAlongTheAxes) {
  const double step = 0.25;
  const Fit fit = fit_to(sloping_lattice(11, 5, 0, 0, {-40, 3, 9}), step, {0, 0, -1});
  // n equidistant points have variance (n² − 1)/12.
  EXPECT_NEAR(fit.u1, step * step * 10, 1e-12);
  EXPECT_NEAR(fit.u2, step * step * 2, 1e-12);
  EXPECT_NEAR(fit.u3, 0, 1e-12);
  EXPECT_NEAR(std::abs(fit.axis1.x()), 1, 1e-12);
  EXPECT_NEAR(std::abs(fit.axis2.y()), 1, 1e-12);
  EXPECT_NEAR(fit.point_variance(), step * step * 12, 1e-12);
}

TEST(Fit, AxesAreOrthonormalAndEigenvaluesDescend) {
  Random random(11);
  for (int round = 0; round < 200; ++round) {
    Moments m;
    const auto count = 2 + random.below(40);
    for (std::uint64_t i = 0; i < count; ++i)
      m.add({static_cast<std::int64_t>(random.below(1000)), static_cast<std::int64_t>(random.below(100)),
             static_cast<std::int64_t>(random.below(10))});
    const Fit fit = fit_to(m, 1, {0, 0, -1});
    Eigen::Matrix3d axes;
    axes << fit.axis1, fit.axis2, fit.normal;
    EXPECT_LT((axes.transpose() * axes - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    EXPECT_GE(fit.u1, fit.u2);
    EXPECT_GE(fit.u2, fit.u3);
    EXPECT_GE(fit.u3, 0);
    EXPECT_NEAR(fit.point_variance(), m.covariance(1).trace(), 1e-9 * fit.u1 + 1e-12);
  }
}

TEST(Fit, NormalIsTurnedAwayFromTheInside) {
  Random random(12);
  for (int round = 0; round < 100; ++round) {
    Moments m;
    for (int i = 0; i < 20; ++i)
      m.add({static_cast<std::int64_t>(random.below(1000)), static_cast<std::int64_t>(random.below(1000)),
             static_cast<std::int64_t>(random.below(1000))});
    const Vector3d inside(random.normal(), random.normal(), random.normal());
    const Fit fit = fit_to(m, 1, inside), opposite = fit_to(m, 1, -inside);
    EXPECT_LE(fit.normal.dot(inside), 0);
    EXPECT_EQ(opposite.normal, -fit.normal);
  }
}

TEST(Fit, OnePointFacesItsSensor) {
  const Fit fit = fit_to(Moments(GridPoint{2, 4, 6}), 0.5, {0.6, 0, 0.8});
  EXPECT_EQ(fit.centroid, Vector3d(1, 2, 3));
  EXPECT_EQ(fit.normal, Vector3d(-0.6, 0, -0.8));
  EXPECT_EQ(fit.point_variance(), 0);
}

/// The noisy readings of a plate 1 × 0.3, its long axis along x.
Fit noisy_fit(Random& random, int count, double noise, double step) {
  Moments m;
  for (int i = 0; i < count; ++i) {
    const Vector3d p(random.uniform(-0.5, 0.5), random.uniform(-0.15, 0.15), noise * random.normal());
    GridPoint at{};
    for (int k = 0; k < 3; ++k)
      at[static_cast<std::size_t>(k)] = static_cast<std::int64_t>(std::floor(p[k] / step + 0.5));
    m.add(at);
  }
  return fit_to(m, step, {0, 0, -1});
}

TEST(Fit, StandardErrorsAreWhatRepeatedScansShow) {
  Random random(13);
  const double noise = 0.005, variance = noise * noise;
  const int rounds = 2000;
  for (const int count : {20, 100}) {
    // Predicted and observed: tilt along the short axis (the worse one), and height at a point 0.3 along
    // each.
    double tilt = 0, tilt_observed = 0;
    double across = 0, across_observed = 0, along = 0, along_observed = 0;
    const Vector3d p(0, 0.3, 0), q(0.3, 0, 0);
    for (int i = 0; i < rounds; ++i) {
      const Fit fit = noisy_fit(random, count, noise, 0x1p-20);
      const double error = fit.normal_error(variance);
      tilt += error * error;
      tilt_observed += fit.normal.y() * fit.normal.y();
      const auto height = [&](const Vector3d& at) {
        const double h = fit.plane().height_of(at);
        return h * h;
      };
      across += fit.height_variance(p, variance), across_observed += height(p);
      along += fit.height_variance(q, variance), along_observed += height(q);
    }
    EXPECT_NEAR(tilt_observed / tilt, 1, 0.15) << count;
    EXPECT_NEAR(across_observed / across, 1, 0.15) << count;
    EXPECT_LT(along_observed, along) << count;  // the formula takes the worse axis everywhere
  }
}

TEST(Fit, NormalErrorFallsWithCountAndExtent) {
  Fit fit;
  fit.u2 = 0.01, fit.count = 25;
  EXPECT_DOUBLE_EQ(fit.normal_error(1e-6), 0.002);
  fit.count = 100;
  EXPECT_DOUBLE_EQ(fit.normal_error(1e-6), 0.001);
  fit.u2 = 0.04;
  EXPECT_DOUBLE_EQ(fit.normal_error(1e-6), 0.0005);
  fit.centroid = {0, 0, 5};
  fit.normal = {0, 0, 1};
  EXPECT_DOUBLE_EQ(fit.height_variance({0, 0, 9}, 1e-6), 1e-8);  // straight above: the height alone
  EXPECT_DOUBLE_EQ(fit.height_variance({0.2, 0, 5}, 1e-6), 2e-8);
}

}  // namespace
}  // namespace limpet::model
