// Copyright the limpet authors. GPL-3.0-or-later.
//
// What a scan tells about itself, against what it was made with.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limpet/survey/estimate.hpp>

#include "copies.hpp"
#include "estimates.hpp"
#include "simulated.hpp"

namespace limpet::survey {
namespace {

using Case = testing::SimulatedScan;

class EstimateTest : public ::testing::TestWithParam<Case> {};

TEST_P(EstimateTest, SpacingAndNoiseComeNearTheTruth) {
  const Case& c = GetParam();
  const auto points = c.make();
  double area = 0;
  for (const auto& face : simulation::faces_of(simulation::make_scene(c.shape).mesh)) area += face.area;

  const Estimate found = estimate([&](const Take& take) {
    for (const auto& p : points) take(p.point);
  });
  const double spacing = std::sqrt(area / static_cast<double>(points.size()));
  EXPECT_EQ(found.points, static_cast<std::int64_t>(points.size()));
  EXPECT_NEAR(std::sqrt(found.area_per_point) / spacing, 1, 0.3);
  EXPECT_NEAR(found.noise.fixed, c.noise, 0.3 * c.noise);
  EXPECT_FALSE(found.noise.varies());
}

using Order = simulation::ScanOptions::Order;
INSTANTIATE_TEST_SUITE_P(Scans, EstimateTest,
                         ::testing::Values(Case{"cube", 10'000, Order::raster, 0, 0},
                                           Case{"cube", 10'000, Order::sampled, 0.002, 0},
                                           Case{"cube", 200'000, Order::raster, 0.005, 0.01},
                                           Case{"cube", 200'000, Order::shuffled, 0.02,
                                                0},  // spacing a quarter of the noise
                                           Case{"L", 50'000, Order::sampled, 0.005, 0.01},
                                           Case{"thin_plate:0.05", 20'000, Order::raster, 0.002, 0},
                                           Case{"step_hole", 100'000, Order::raster, 0.002, 0},
                                           Case{"room:1", 100'000, Order::sampled, 0.005, 0},
                                           Case{"city:25", 100'000, Order::raster, 0.005, 0.01}),
                         [](const auto& test) {
                           const std::string shape = test.param.shape.substr(0, test.param.shape.find(':'));
                           return shape + "_" + std::to_string(test.index);
                         });

/// One record at 10³⁰ made all else look exact: noise 0, and a model without a polygon.
TEST(Estimate, WildRecordsSayNothing) {
  for (const std::int64_t count : {5'000, 60'000}) {
    const auto points = Case{"cube", count, simulation::ScanOptions::Order::sampled, 0.002, 0}.make();
    const auto estimate_with = [&](const std::vector<double>& wild) {
      return estimate([&](const Take& take) {
        for (const double far : wild) take({Eigen::Vector3d(far, -far, 0), Eigen::Vector3d::UnitZ()});
        for (const auto& p : points) take(p.point);
      });
    };
    const Estimate truth = estimate_with({}), found = estimate_with({1e30, -1e200, 1e5});
    EXPECT_NEAR(found.noise.fixed / truth.noise.fixed, 1, 0.1);
    EXPECT_NEAR(found.area_per_point / truth.area_per_point, 1, 0.1);
    EXPECT_EQ(found.noise.varies(), false);
  }
}

TEST(Estimate, NothingToSay) {
  EXPECT_EQ(estimate([](const Take&) {}).area_per_point, 0);
  const Estimate same = estimate([](const Take& take) {
    for (int i = 0; i < 100; ++i) take({Eigen::Vector3d(1, 2, 3), Eigen::Vector3d::UnitZ()});
  });
  EXPECT_EQ(same.area_per_point, 0);
}

TEST(Estimate, ARowOfPointsIsNoSurface) {
  const Estimate row = estimate([](const Take& take) {
    for (int i = 0; i < 1000; ++i) take({Eigen::Vector3d(0.01 * i, 0, 0), Eigen::Vector3d::UnitZ()});
  });
  EXPECT_EQ(row.area_per_point, 0);
}

std::vector<model::SensorPoint> points_of(const Case& scan) {
  std::vector<model::SensorPoint> points;
  for (const auto& p : scan.make()) points.push_back(p.point);
  return points;
}

Estimate estimate_once(const std::vector<model::SensorPoint>& points) {
  Sample sample;
  for (const auto& p : points) sample.add(p);
  return estimate(sample);
}

void expect_alike(const Estimate& found, const Estimate& truth) {
  EXPECT_NEAR(found.area_per_point / truth.area_per_point, 1, 0.04);
  EXPECT_NEAR(found.sparse_area / truth.sparse_area, 1, 0.08);
  EXPECT_NEAR(found.noise.fixed / truth.noise.fixed, 1, 0.04);
}

/// Copies in every order, of scans that fit in the sample with them, without them and not at all.
TEST(Estimate, CopiesCountOnce) {
  for (const std::int64_t count : {5'000, 15'000, 50'000, 200'000}) {
    const auto points = points_of({"cube", count, Order::raster, 0.002, 0});
    const Estimate single = estimate_of(points), single_once = estimate_once(points);
    for (const testing::Copies order : testing::kAllCopies) {
      SCOPED_TRACE(std::to_string(count) + ", order " + std::to_string(static_cast<int>(order)));
      const auto copies = testing::thrice(points, order, 1);
      expect_alike(estimate_of(copies), single);
      expect_alike(estimate_once(copies), single_once);
      EXPECT_EQ(estimate_of(copies).points, static_cast<std::int64_t>(copies.size()));
    }
  }
}

TEST(Estimate, CopiesOfAPartCountOnce) {
  for (const std::int64_t count : {5'000, 50'000}) {
    const auto points = points_of({"cube", count, Order::sampled, 0.002, 0});
    for (const int times : {2, 7}) {
      auto copies = points;
      for (int i = 1; i < times; ++i) {
        for (const auto& p : points) {
          if (p.position.x() < 0.3) copies.push_back(p);
        }
      }
      SCOPED_TRACE(std::to_string(count) + ", " + std::to_string(times) + " times");
      expect_alike(estimate_of(copies), estimate_of(points));
    }
  }
}

/// An image of a desk before a wall, by a camera that rounds depths to steps that grow with their square;
/// turned about the camera afterwards, and written with the seven digits of a float.
std::vector<model::SensorPoint> depth_image(const Eigen::Matrix3d& turn) {
  constexpr double kStep = 0.002;  // of the inverse of the depth
  std::vector<model::SensorPoint> points;
  for (int v = -120; v < 120; ++v) {
    for (int u = -160; u < 160; ++u) {
      const Eigen::Vector3d ray(u / 300.0, v / 300.0, 1);
      const Eigen::Vector3d wall(0.1, 0, 1), desk(0, 1, -0.2);
      double depth = 4 / wall.dot(ray);
      if (desk.dot(ray) > 0) depth = std::min(depth, 0.4 / desk.dot(ray));
      const Eigen::Vector3d at = turn * ray / (kStep * std::round(1 / depth / kStep));
      points.push_back({at.cast<float>().cast<double>(), at.normalized(), at.norm()});
    }
  }
  return points;
}

TEST(Estimate, RoundedDepthsAreNoiseHoweverTheScanIsTurned) {
  const auto noise_at = [](const Eigen::Matrix3d& turn, double range) {
    const auto points = depth_image(turn);
    return estimate([&](const Take& take) {
             for (const auto& p : points) take(p);
           })
        .noise.at(range);
  };
  const Eigen::Matrix3d as_taken = Eigen::Matrix3d::Identity();
  const double step_of_wall = 0.002 * 4 * 4;
  EXPECT_NEAR(noise_at(as_taken, 4) / (step_of_wall / std::sqrt(12.0)), 1, 0.5);
  for (const double angle : {0.1, 0.7, 2.0}) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
    for (const double range : {2.0, 4.0})
      EXPECT_NEAR(noise_at(turn, range) / noise_at(as_taken, range), 1, 0.1) << range << ' ' << angle;
  }
}

}  // namespace
}  // namespace limpet::survey
