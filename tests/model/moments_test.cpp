// Copyright the limpet authors. GPL-3.0-or-later.
#include <cmath>

#include <gtest/gtest.h>

#include <limpet/survey/random.hpp>

#include "grid_clouds.hpp"

namespace limpet::model {
namespace {

using namespace testing;
using survey::Random;

/// Points with coordinates 1 to `extent`.
Cloud cloud(std::uint64_t seed, std::size_t count, std::uint64_t extent) {
  Random random(seed);
  Cloud points;
  for (std::size_t i = 0; i < count; ++i) {
    GridPoint p{};
    for (auto& x : p) x = 1 + static_cast<std::int64_t>(random.below(extent));
    points.push_back(p);
  }
  return points;
}

Cloud moved(Cloud points, const GridPoint& by) {
  for (auto& p : points)
    for (std::size_t i = 0; i < 3; ++i) p[i] += by[i];
  return points;
}

/// In units of step², centred first.
Eigen::Matrix<long double, 3, 3> reference_covariance(const Cloud& points) {
  Eigen::Matrix<long double, 3, 1> mean = Eigen::Matrix<long double, 3, 1>::Zero();
  for (const auto& p : points)
    for (int i = 0; i < 3; ++i) mean[i] += static_cast<long double>(p[static_cast<std::size_t>(i)]);
  mean /= static_cast<long double>(points.size());
  Eigen::Matrix<long double, 3, 3> sum = Eigen::Matrix<long double, 3, 3>::Zero();
  for (const auto& p : points) {
    Eigen::Matrix<long double, 3, 1> d;
    for (int i = 0; i < 3; ++i) d[i] = static_cast<long double>(p[static_cast<std::size_t>(i)]) - mean[i];
    sum += d * d.transpose();
  }
  return sum / static_cast<long double>(points.size());
}

TEST(Moments, AreTheSameInWhateverOrderPointsComeAndSegmentsMerge) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Cloud points = moved(cloud(seed, 200, 1u << 30), {-(1 << 29), 1'000'000'000'000, -123456789});
    const Moments in_order = moments_of(points);
    Random random(seed);
    std::vector<Moments> parts;
    for (const auto& p : points) parts.emplace_back(p);
    while (parts.size() > 1) {
      const auto from = random.below(parts.size());
      std::swap(parts[from], parts.back());
      const Moments last = parts.back();
      parts.pop_back();
      parts[random.below(parts.size())].add(last);
    }
    EXPECT_TRUE(same(in_order, parts[0])) << "seed " << seed;
    EXPECT_EQ(in_order.covariance(0.25), parts[0].covariance(0.25)) << "seed " << seed;
  }
}

TEST(Moments, ComeBackFromTheirRecord) {
  const Moments m = moments_of(moved(cloud(3, 50, 1000), {-(std::int64_t{1} << 47), 0, 77}));
  EXPECT_TRUE(same(m, Moments(m.record())));
  EXPECT_EQ(m.centroid(0.5), Moments(m.record()).centroid(0.5));
}

TEST(Moments, CovarianceIsThatOfTheCentredPoints) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Cloud points = cloud(seed, 3 + 20 * seed, 1u << 20);
    const auto expected = reference_covariance(points);
    const Eigen::Matrix3d c = moments_of(points).covariance(1);
    const double size = static_cast<double>(expected.trace());
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        EXPECT_NEAR(c(i, j), static_cast<double>(expected(i, j)), 1e-14 * size) << "seed " << seed;
  }
}

TEST(Moments, CovarianceDoesNotChangeWhenThePointsMove) {
  for (const std::int64_t distance :
       {std::int64_t{1'000'000}, std::int64_t{1'000'000'000}, std::int64_t{1'000'000'000'000},
        std::int64_t{100'000'000'000'000}, kMaxSteps - 5000}) {
    const Cloud points = cloud(7, 1000, 5000);
    const Eigen::Matrix3d near = moments_of(points).covariance(1);
    EXPECT_EQ(near, moments_of(moved(points, {distance, distance, distance})).covariance(1)) << distance;
    // On the other side of the origin the mean is rounded the other way: equal but for the last bits.
    const Eigen::Matrix3d opposite =
        moments_of(moved(points, {-distance, distance, -distance})).covariance(1);
    EXPECT_LT((near - opposite).cwiseAbs().maxCoeff(), 1e-14 * near.trace()) << distance;
  }
}

TEST(Moments, CentroidIsTheMean) {
  const std::int64_t far = 1'000'000'000'000;
  const Moments m = moments_of({{far, -far, 0}, {far + 1, -far - 1, 1}, {far + 2, -far - 5, -4}});
  EXPECT_EQ(m.centroid(1), Eigen::Vector3d(1e12 + 1, -1e12 - 2, -1));
  EXPECT_EQ(m.centroid(0.125), 0.125 * Eigen::Vector3d(1e12 + 1, -1e12 - 2, -1));
  EXPECT_EQ(m.count(), 3);
}

TEST(Moments, HoldAtTheEdgeOfTheirRange) {
  Moments m;
  for (int i = 0; i < 1 << 14; ++i) {
    m.add({kMaxSteps, -kMaxSteps, kMaxSteps});
    m.add({-kMaxSteps, kMaxSteps, kMaxSteps});
  }
  for (int doubling = 0; doubling < 12; ++doubling) m.add(Moments(m));  // 2^27 points
  EXPECT_EQ(m.count(), std::int64_t{1} << 27);
  const Eigen::Matrix3d c = m.covariance(1);
  const double square = std::ldexp(1.0, 96);
  Eigen::Matrix3d expected;
  expected << square, -square, 0, -square, square, 0, 0, 0, 0;
  EXPECT_EQ(c, expected);
  EXPECT_EQ(m.centroid(1), Eigen::Vector3d(0, 0, std::ldexp(1.0, 48)));
}

TEST(Moments, SquaredResidualIsTheMeanSquaredDistanceFromThePlane) {
  Random random(5);
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const GridPoint far = {1'000'000'000 * static_cast<std::int64_t>(seed), -77'000'000, 0};
    const Cloud points = moved(cloud(seed, seed, 4000), far);
    const double step = 0x1p-10;
    geometry::Plane plane;
    plane.normal = Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
    for (int i = 0; i < 3; ++i)
      plane.point[i] =
          step * (static_cast<double>(far[static_cast<std::size_t>(i)]) + random.uniform(0, 4000));
    long double sum = 0;
    for (const auto& p : points) {
      long double h = 0;
      for (int i = 0; i < 3; ++i)
        h += static_cast<long double>(plane.normal[i]) *
             (static_cast<long double>(p[static_cast<std::size_t>(i)]) * step - plane.point[i]);
      sum += h * h;
    }
    const auto expected = static_cast<double>(sum / static_cast<long double>(points.size()));
    EXPECT_NEAR(moments_of(points).squared_residual(plane, step), expected, 1e-9 * (1 + expected))
        << "seed " << seed;
  }
}

TEST(Moments, OnePointHasNoSpread) {
  const Moments m(GridPoint{5, -6, 7});
  EXPECT_EQ(m.covariance(1), Eigen::Matrix3d::Zero());
  EXPECT_EQ(m.squared_residual({{0, 0, 0}, {0, 0, 1}}, 0.5), 3.5 * 3.5);
}

}  // namespace
}  // namespace limpet::model
