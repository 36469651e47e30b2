// Copyright the limpet authors. GPL-3.0-or-later.
//
// What readings say of where no surface is (docs/rules.md, `rays`). The sensor is at a height of 3.
#include <gtest/gtest.h>

#include <limpet/io/lifted.hpp>

#include "streams.hpp"

namespace limpet::model {
namespace {

using namespace testing;

constexpr double kSensor = 3;

/// The points, at this height, with their distance from the sensor.
Points at_height(Points points, double z) {
  for (auto& p : points) p.position.z() += z, p.range = kSensor - z;
  return points;
}

ModelRecord record_of(const Points& points, const char* rules) {
  Parameters parameters = of_resolution(0.1);
  parameters.noise = 0.002;
  parameters.rules = Rules::parse(rules);
  const ModelRecord record = modelled(parameters, points).record();
  EXPECT_EQ(broken_laws(record), "") << rules;
  return record;
}

/// Something that was there, young or mature, and then was not: the floor was seen through it.
TEST(Rays, WhatIsSeenThroughIsNoSurface) {
  for (const auto& [seen_before, side] : {std::pair(60, 0.3), std::pair(400, 0.6)}) {
    SCOPED_TRACE(seen_before);
    Random random(3);
    Points points = at_height(plate(random, seen_before, 0.6, 0.6, 0.6 + side, 0.6 + side, 0.002), 1);
    for (const auto& p : at_height(plate(random, 3000, 0, 0, 2, 2, 0.002), 0)) points.push_back(p);
    EXPECT_EQ(record_of(points, "-rays").polygon_segments.size(), 2u);
    const ModelRecord record = record_of(points, "limpet");
    ASSERT_EQ(record.polygon_segments.size(), 1u);
    EXPECT_NEAR(io::area(io::lift(record).front()), 4, 0.2);
    Points without_range = points;
    for (auto& p : without_range) p.range = 0;
    EXPECT_EQ(record_of(without_range, "limpet").polygon_segments.size(), 2u);
  }
}

/// Something before the floor, seen with it, hides it and stays; so does what a few outliers lie behind.
TEST(Rays, WhatHidesStays) {
  Random random(4);
  Points points;
  for (const auto& p : plate(random, 6000, 0, 0, 2, 2, 0.002)) {
    const double x = p.position.x(), y = p.position.y();
    const bool hidden = x > 0.6 && x < 1.2 && y > 0.6 && y < 1.2;
    const bool outlier = random.uniform() < 0.02;
    points.push_back(at_height({p}, outlier ? random.uniform(-1, 1.5) : hidden ? 1 : 0).front());
  }
  EXPECT_EQ(record_of(points, "limpet").polygon_segments.size(), 2u);
}

/// A plate with 25 holes of 1.7 λ, at eight readings to λ²: chance could leave them empty, but the floor was
/// seen through them.
TEST(Rays, HolesThatWereSeenThroughAreNotFilled) {
  Random random(5);
  Points points;
  for (const auto& p : plate(random, 8 * 900, 0, 0, 3, 3, 0.002)) {
    const auto off = [](double x) { return std::abs(std::fmod(x, 0.6) - 0.3); };
    const bool hole = off(p.position.x()) < 0.085 && off(p.position.y()) < 0.085;
    points.push_back(at_height({p}, hole ? 0 : 1).front());
  }
  const auto holes = [&](const char* rules) {
    std::size_t most = 0;
    for (const auto& s : record_of(points, rules).polygon_segments) most = std::max(most, s.cycles.size());
    return most - 1;
  };
  EXPECT_GE(holes("limpet"), 24u);
  EXPECT_LT(holes("-rays"), 10u);
}

}  // namespace
}  // namespace limpet::model
