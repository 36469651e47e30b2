// Copyright the limpet authors. GPL-3.0-or-later.
//
// Redundant segments are deleted (thesis §2.9), and what they represent is kept where it fits.
#include <gtest/gtest.h>

#include "judged_scan.hpp"

namespace limpet::model {
namespace {

using namespace testing;

/// A plate, and half of λ above its middle a patch of points that fit it no more: a plane of their own.
Points plate_and_patch(std::uint64_t seed) {
  Random random(seed);
  Points points = plate(random, 5000, 0, 0, 2, 2, 0.001);
  Points patch = plate(random, 60, 0.9, 0.9, 1.1, 1.1, 0.001);
  for (auto& p : patch) p.position.z() += 0.05;
  points.insert(points.end(), patch.begin(), patch.end());
  shuffle(points, random);
  return points;
}

Model model_of(const Points& points, const std::string& rules) {
  Parameters parameters = of_resolution(0.1);
  parameters.noise = 0.001;
  parameters.rules = Rules::parse(rules);
  return modelled(parameters, points);
}

TEST(Redundancy, SegmentsThatLieOnOthersGo) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Points points = plate_and_patch(seed);
    const Model model = model_of(points, "limpet"), keeping = model_of(points, "-position");
    EXPECT_EQ(keeping.record().polygon_segments.size(), 2u);
    const ModelRecord record = model.record();
    EXPECT_EQ(broken_laws(record), "");
    EXPECT_EQ(record.polygon_segments.size(), 1u);
    EXPECT_EQ(model.counts().redundant_by_position, 1);
    // The books still hold every point: in segments, or given up since it fits nothing.
    EXPECT_EQ(points_in_segments(record) + record.expired, record.points);
    EXPECT_GT(record.expired, 0);
    EXPECT_LE(record.expired, 60);
  }
}

/// Of two small plates of nearly as many points that lie half of λ apart, neither is redundant.
TEST(Redundancy, OfTwoThatWereFeltAlikeNeitherGoes) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Points points = plate(random, 60, 0, 0, 0.2, 0.2, 0.001);
    Points above = plate(random, 50, 0, 0, 0.2, 0.2, 0.001);
    for (auto& p : above) p.position.z() += 0.05;
    points.insert(points.end(), above.begin(), above.end());
    EXPECT_EQ(model_of(points, "limpet").record().polygon_segments.size(), 2u);
  }
}

/// A thin plate has a back: its two sides lie within λ of each other and face away from each other.
TEST(Redundancy, TheBackOfAThinPlateStays) {
  simulation::ScanOptions options;
  options.points = 10'000;
  options.order = Order::sampled;
  const JudgedScan scan = judged_scan(simulation::make_scene("thin_plate:0.025").mesh, 0.05, 0.002, options);
  const ModelRecord record = modelled(scan.parameters, scan.points).record();
  int up = 0, down = 0;
  for (const auto& s : record.polygon_segments) {
    if (s.moments.count < 1000) continue;
    up += normal_of(s).z() > 0.9, down += normal_of(s).z() < -0.9;
  }
  EXPECT_EQ(up, 1);
  EXPECT_EQ(down, 1);
}

/// A floor and a wall, 36 readings to λ², and a strip 1.8 λ wide across their edge.
Points floor_wall_and_strip(std::uint64_t seed, int strip_readings) {
  Random random(seed);
  const double from = 0.13;
  Points points = plate(random, 3600, from, 0, from + 1, 1, 0.001);
  for (auto& p : plate(random, 3600, from, 0, from + 1, 1, 0.001))
    points.push_back({{p.position.z(), p.position.y(), p.position.x()}, Vector3d(-1, 0, 0)});
  for (auto& p : plate(random, strip_readings, 0, 0, from, 1, 0.001))
    points.push_back(
        {{p.position.x() + p.position.z(), p.position.y(), from - p.position.x() + p.position.z()},
         Vector3d(-1, 0, -1).normalized()});
  shuffle(points, random);
  return points;
}

/// What lies across an edge goes where it was felt much less densely than the faces there; a chamfer stays.
TEST(Redundancy, WhatLiesAcrossAnEdgeGoesUnlessItWasFeltAsDensely) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Points thin = floor_wall_and_strip(seed, 250), dense = floor_wall_and_strip(seed, 650);
    EXPECT_EQ(model_of(thin, "-position").record().polygon_segments.size(), 3u);
    EXPECT_EQ(model_of(thin, "limpet").record().polygon_segments.size(), 2u);
    EXPECT_EQ(model_of(dense, "limpet").record().polygon_segments.size(), 3u);
  }
}

}  // namespace
}  // namespace limpet::model
