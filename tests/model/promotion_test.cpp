// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <cmath>
#include <limpet/model/model.hpp>

namespace limpet::model {
namespace {

SensorPoint down(double x, double y, double z) { return {{x, y, z}, {0.3, 0.2, -0.9}}; }

Model polygons_of(const std::vector<SensorPoint>& points, const Rules& rules = {}) {
  Parameters parameters;
  parameters.resolution = 0.05;
  parameters.noise = 0;
  parameters.rules = rules;
  Model model(parameters);
  model.update(points);
  model.finish();
  return model;
}

/// Nine points of a scan line and some beside it lie in a plane only because so few do.
std::vector<SensorPoint> line_and(int outliers) {
  std::vector<SensorPoint> points;
  for (int i = 0; i < 9; ++i) points.push_back(down(0.009 * i, -0.007 * i, 0));
  for (int k = 0; k < outliers; ++k)
    points.push_back(down(0.03 + 0.01 * k, -0.03 - 0.011 * k, -0.017 - 0.003 * k));
  return points;
}

TEST(Promotion, AScanLineAndAnOutlierAreNoPlane) {
  EXPECT_EQ(polygons_of(line_and(0)).counts().polygons, 0);
  EXPECT_EQ(polygons_of(line_and(1)).counts().polygons, 0);
  // Which is what the rule is for: without it one outlier decides on the plane.
  EXPECT_GT(polygons_of(line_and(1), Rules::parse("-chance")).counts().polygons, 0);
}

TEST(Promotion, APatchOfThinlyScannedPlaneIsFoundTogether) {
  std::vector<SensorPoint> points;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j)
      points.push_back(down(0.024 * i + 0.003 * (j % 3), 0.024 * j + 0.002 * (i % 2), 0));
  const Model model = polygons_of(points);
  EXPECT_EQ(model.counts().polygons, 1);
  EXPECT_EQ(model.counts().loose, 0);
}

TEST(Promotion, ReadingsThatGrazeAPlaneMakeNone) {
  const auto seen_at = [](double degrees_from_normal) {
    const double angle_rad = degrees_from_normal * M_PI / 180;
    std::vector<SensorPoint> points;
    for (int i = 0; i < 8; ++i)
      for (int j = 0; j < 8; ++j)
        points.push_back({{0.02 * i, 0.02 * j, 0}, {std::sin(angle_rad), 0, -std::cos(angle_rad)}});
    return polygons_of(points).counts().polygons;
  };
  EXPECT_EQ(seen_at(83), 1);
  EXPECT_EQ(seen_at(87), 0);
}

TEST(Promotion, OpposedSensingAxesDoNotMerge) {
  std::vector<SensorPoint> points;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) {
      points.push_back({{0.02 * i, 0.02 * j, 0}, {0, 0, -1}});
      points.push_back({{0.02 * i, 0.02 * j, -0.01}, {0, 0, 1}});  // the back of a thin plate
    }
  EXPECT_EQ(polygons_of(points).counts().polygons, 2);
}

}  // namespace
}  // namespace limpet::model
