// Copyright the limpet authors. GPL-3.0-or-later.
//
// Points of a small face's polygon that are another face's (docs/rules.md, `strays`).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "judged_scan.hpp"

namespace limpet::model {
namespace {

using namespace testing;

constexpr double kRidgeNoise = 0.006, kRidgeSlope = 0.45;

/// Two faces of 3 λ by 3 λ that meet in a blunt edge, 24°, of which the strip along the edge comes first.
Points ridge(std::uint64_t seed) {
  Random random(seed);
  Points points = plate(random, 100, -0.3, 0, 0.3, 0.3, kRidgeNoise);
  for (auto& p : points) p.position.z() -= kRidgeSlope * std::max(0.0, p.position.x());
  std::stable_partition(points.begin(), points.end(),
                        [](const SensorPoint& p) { return std::abs(p.position.x()) < 0.1; });
  return points;
}

/// Of the polygons found, the largest angle to the face they are nearest to, degrees.
double worst_angle(const ModelRecord& record) {
  double worst = 0;
  for (const auto& polygon : record.polygon_segments) {
    const Eigen::Vector3d flat(0, 0, 1), steep = Eigen::Vector3d(kRidgeSlope, 0, 1).normalized();
    const Eigen::Vector3d normal =
        (polygon.chart_normal - polygon.height[1] * polygon.chart_u - polygon.height[2] * polygon.chart_v)
            .normalized();
    worst = std::max(worst, std::acos(std::clamp(std::max(normal.dot(flat), normal.dot(steep)), -1.0, 1.0)));
  }
  return worst * 180 / M_PI;
}

TEST(Strays, ArePartedFromASmallFace) {
  int two = 0, two_without = 0;
  double angle = 0, angle_without = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    for (const bool with : {true, false}) {
      Parameters parameters = of_resolution(0.1);
      parameters.noise = kRidgeNoise;
      parameters.tolerance = 0.02;
      if (!with) parameters.rules = Rules::parse("-strays");
      const ModelRecord record = modelled(parameters, ridge(seed)).record();
      EXPECT_EQ(broken_laws(record), "");
      (with ? two : two_without) += record.polygon_segments.size() == 2;
      (with ? angle : angle_without) += worst_angle(record) / 40;
    }
  }
  // Measured: 36 of 40 against 18, 1.9° against 7.1°.
  EXPECT_GE(two, 32);
  EXPECT_LE(two_without, 24);
  EXPECT_LT(angle, angle_without / 2);
}

}  // namespace
}  // namespace limpet::model
