// Copyright the limpet authors. GPL-3.0-or-later.
//
// Clouds whose axes are known, oriented without them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limpet/survey/estimate.hpp>
#include <limpet/survey/orientation.hpp>
#include <limpet/survey/random.hpp>
#include <vector>

#include "simulated.hpp"

namespace limpet::survey {
namespace {

/// A cloud, and the outward normal of each point's face: the side it was sensed from.
struct Cloud {
  std::vector<simulation::LabelledPoint> points;
  std::vector<Eigen::Vector3d> normals;  ///< by face
};
using Order = simulation::ScanOptions::Order;

Cloud scan_of(const testing::SimulatedScan& scan) {
  Cloud cloud{scan.make(), {}};
  for (const auto& face : simulation::faces_of(simulation::make_scene(scan.shape).mesh))
    cloud.normals.push_back(face.normal);
  return cloud;
}

Orientation orient(const Cloud& cloud) {
  const Estimate found = estimate([&](const Take& take) {
    for (const auto& p : cloud.points) take({p.point.position, Eigen::Vector3d::Zero()});
  });
  const double resolution = suitable_resolution(found, found.noise).fixed;
  Orientation orientation(
      Orientation::suitable_edge(found.area_per_point, found.noise.at(found.far_range), resolution));
  for (const auto& p : cloud.points) orientation.add(p.point.position);
  orientation.solve();
  return orientation;
}

/// Of the points on the surface, the shares whose axis points into their face, and out of it. The rest,
/// within 10° of the face, lie at an edge and have the axis of the face beyond.
struct Shares {
  double right = 0, wrong = 0;
};

Shares shares(const Orientation& orientation, const Cloud& cloud) {
  std::int64_t right = 0, wrong = 0, all = 0;
  for (const auto& p : cloud.points) {
    if (p.face < 0) continue;
    const Eigen::Vector3d axis = orientation.axis(p.point.position);
    EXPECT_NEAR(axis.norm(), 1, 1e-9);
    const double inward = -axis.dot(cloud.normals[p.face]);
    right += inward > 0.17;
    wrong += inward < -0.17;
    ++all;
  }
  const auto n = static_cast<double>(all);
  return {static_cast<double>(right) / n, static_cast<double>(wrong) / n};
}

Shares shares(const Cloud& cloud) { return shares(orient(cloud), cloud); }

using Case = testing::SimulatedScan;

class OrientationTest : public ::testing::TestWithParam<Case> {};

TEST_P(OrientationTest, IsThatOfTheSensors) {
  const Case& c = GetParam();
  const Cloud cloud = scan_of(c);
  const Shares found = shares(cloud);
  std::printf("%.3f %% right, %.3f %% wrong\n", 100 * found.right, 100 * found.wrong);
  EXPECT_GE(found.right, 0.98);
  EXPECT_LE(found.wrong, 0.002);
}

INSTANTIATE_TEST_SUITE_P(Scans, OrientationTest,
                         ::testing::Values(Case{"cube", 10'000, Order::raster, 0, 0},
                                           Case{"cube", 50'000, Order::sampled, 0.002, 0.01},
                                           Case{"cube", 200'000, Order::shuffled, 0.02, 0},
                                           Case{"L", 50'000, Order::raster, 0.002, 0.01},
                                           Case{"step_hole", 50'000, Order::sampled, 0.002, 0.01},
                                           Case{"thin_plate:0.2", 20'000, Order::raster, 0.001, 0},
                                           Case{"city:25", 100'000, Order::raster, 0.005, 0.01},
                                           Case{"city:100", 400'000, Order::sampled, 0.005, 0}),
                         [](const auto& test) {
                           const std::string shape = test.param.shape.substr(0, test.param.shape.find(':'));
                           return shape + "_" + std::to_string(test.index);
                         });

/// What was scanned from inside is one piece too, but nothing says that it is inside out.
TEST(Orientation, ARoomIsConsistentAndInsideOut) {
  const Cloud cloud = scan_of({"room:1", 100'000, Order::sampled, 0.002, 0});
  EXPECT_GE(shares(cloud).wrong, 0.97);
}

TEST(Orientation, DoesNotDependOnPlaceNorOnOrder) {
  const Cloud cloud = scan_of({"step_hole", 30'000, Order::sampled, 0.001, 0});
  Cloud moved = cloud, reversed = cloud;
  for (auto& p : moved.points) p.point.position += Eigen::Vector3d(12345.6, -7654.3, 321);
  std::reverse(reversed.points.begin(), reversed.points.end());
  EXPECT_GE(shares(moved).right, 0.99);
  EXPECT_GE(shares(reversed).right, 0.99);
  const Orientation first = orient(cloud), second = orient(cloud);
  for (const auto& p : cloud.points) {
    EXPECT_EQ(first.axis(p.point.position), second.axis(p.point.position));
  }
}

/// A wedge of 30°: the normals of its two sides nearly oppose each other, and yet both are outward.
TEST(Orientation, HoldsAcrossASharpEdge) {
  const std::uint64_t seed = 3;
  RecordProperty("seed", std::to_string(seed));
  Random random(seed);
  const double half = 15 * M_PI / 180;
  Cloud wedge;
  for (const double side : {1.0, -1.0}) wedge.normals.emplace_back(0, side * std::cos(half), std::sin(half));
  for (int i = 0; i < 20'000; ++i) {
    const double along = random.uniform(), down = random.uniform(), side = i % 2 == 0 ? 1 : -1;
    const Eigen::Vector3d position(along, side * down * std::sin(half), -down * std::cos(half));
    wedge.points.push_back({{position, -wedge.normals[i % 2]}, i % 2});
  }
  const Shares found = shares(wedge);
  EXPECT_GE(found.right, 0.99);
  EXPECT_LE(found.wrong, 0.001);
}

TEST(Orientation, AWallIsOfOneSide) {
  const auto place = [](int i) {
    const int row = i / 100;
    return Eigen::Vector3d(0.01 * (i % 100), 0, 0.01 * row);
  };
  Orientation orientation(0.1);
  for (int i = 0; i < 10'000; ++i) orientation.add(place(i));
  orientation.solve();
  EXPECT_EQ(orientation.components(), 1);
  const Eigen::Vector3d axis = orientation.axis({0.5, 0, 0.5});
  EXPECT_NEAR(std::abs(axis.y()), 1, 1e-9);
  for (int i = 0; i < 10'000; i += 7) {
    EXPECT_NEAR(orientation.axis(place(i)).dot(axis), 1, 1e-9);
  }
}

TEST(Orientation, NothingToGoBy) {
  Orientation empty(1);
  empty.solve();
  EXPECT_EQ(empty.axis({0, 0, 0}), -Eigen::Vector3d::UnitZ());
  EXPECT_EQ(empty.components(), 0);
  Orientation scattered(1);
  for (int i = 0; i < 5; ++i) scattered.add({10.0 * i, 0, 0});
  scattered.add({1e300, 0, 0});
  scattered.add({0, -1e18, 0});
  scattered.solve();
  EXPECT_EQ(scattered.axis({10, 0, 0}), -Eigen::Vector3d::UnitZ());
  EXPECT_EQ(scattered.axis({1e300, 0, 0}), -Eigen::Vector3d::UnitZ());
}

}  // namespace
}  // namespace limpet::survey
