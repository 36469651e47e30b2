// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/following/clearance.hpp>
#include <limpet/survey/random.hpp>

#include "initial_model.hpp"
#include "random_places.hpp"

namespace limpet::following {
namespace {

using Eigen::Vector3d;

constexpr double kLeast = 0.05;

/// The distance of a place from obstacles that are all points, by trying all.
double nearest(const std::vector<model::SensorPoint>& points, const Vector3d& p) {
  double least = 1e300;
  for (const auto& q : points) least = std::min(least, (q.position - p).norm());
  return least;
}

TEST(Clearance, AShortenedMotionIsClearAllAlong) {
  survey::Random random(1);
  const model::Model model = initial_model({{rectangle(-0.2, -0.2, 0.2, 0.2)}});
  for (int round = 0; round < 300; ++round) {
    std::vector<model::SensorPoint> readings(5);
    for (auto& reading : readings) reading.position = random_place(random, 0.3);
    Clearance clearance(kLeast);
    clearance.remember(readings);
    const Vector3d from = random_place(random, 0.3), motion = random_place(random, 0.1);
    const Vector3d to = clearance.shortened(model.view(), from, motion);
    const double start = std::min(nearest(readings, from), model.view().nearest(from, 10)->distance);
    for (int i = 0; i <= 20; ++i) {
      const Vector3d p = from + i / 20.0 * to;
      const double now = std::min(nearest(readings, p), model.view().nearest(p, 10)->distance);
      EXPECT_GE(now, std::min(start, kLeast) - 1e-12) << "round " << round;
    }
  }
}

TEST(Clearance, ASafePlanKeepsOffSuspectedPlaces) {
  const model::Model model = initial_model({{rectangle(10, 10, 11, 11)}});
  Clearance clearance(kLeast);
  const Vector3d from(0, 0, 0), to(1, 0, 0);
  EXPECT_TRUE(clearance.is_safe(model.view(), from, to, 0.1));
  clearance.suspect({{0.5, 0.09, 0}});
  EXPECT_FALSE(clearance.is_safe(model.view(), from, to, 0.1));
  EXPECT_TRUE(clearance.is_clear(model.view(), from, to)) << "what is suspected does not stop a motion";
  EXPECT_TRUE(clearance.is_safe(model.view(), from, {0.3, 0, 0}, 0.1));
}

/// Sets that find nothing count, too: what is wrong does not stay in the way of a robot that waits.
TEST(Clearance, ReadingsAreForgottenAfter80Sets) {
  const model::Model model = initial_model({{rectangle(10, 10, 11, 11)}});
  Clearance clearance(kLeast);
  clearance.remember(std::vector<model::SensorPoint>{{{0.02, 0, 0}, {1, 0, 0}, 0.1}});
  for (int set = 1; set < 80; ++set) clearance.remember({});
  EXPECT_EQ(clearance.at(model.view(), {0, 0, 0}, 1), 0.02);
  clearance.remember({});
  EXPECT_EQ(clearance.at(model.view(), {0, 0, 0}, 1), 1);
}

TEST(Clearance, FromTooNearOnlyWaysThatLeadAwayAreClear) {
  const model::Model model = initial_model({{rectangle(-1, -1, 1, 1)}});
  const Clearance clearance(kLeast);
  const Vector3d near(0, 0, 0.02);
  EXPECT_TRUE(clearance.is_clear(model.view(), near, {0, 0, 0.04}));
  EXPECT_FALSE(clearance.is_clear(model.view(), near, {0, 0, 0.01}));
  EXPECT_FALSE(clearance.is_clear(model.view(), near, {0.02, 0, 0.02}));
}

}  // namespace
}  // namespace limpet::following
