// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/following/transit/steering_internal.hpp>
#include <string>

#include "initial_model.hpp"
#include "random_places.hpp"

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;

/// A point robot at a place, that knows of a model and of some readings.
struct Situation {
  model::Model model;
  Clearance clearance{usual_parameters(kLambda).clearance()};
  kinematics::Robot robot = kinematics::point_robot({4 * kLambda, kLambda, Eigen::Quaterniond::Identity()});

  explicit Situation(const std::vector<std::vector<Cycle>>& faces) : model(initial_model(faces)) {}

  Vector3d towards(const Vector3d& here, const Vector3d& there, double step = kStep) const {
    const model::View view = model.view();
    const kinematics::Posture posture(robot, here);
    return Steering(view, clearance, posture, step).towards(there);
  }
  double distance(const Vector3d& p) const { return clearance.at(model.view(), p, 10); }
};

/// A floor, and a wall at x = 0.3 that faces −x.
Situation corner() {
  const Cycle wall{{0.3, -1, 0}, {0.3, -1, 1}, {0.3, 1, 1}, {0.3, 1, 0}};
  return Situation({{rectangle(-1, -1, 0.3, 1)}, {wall}});
}

TEST(Steering, GoesStraightWhereNothingIsNear) {
  const Situation free({{rectangle(0, 0, 1, 1, 10)}});
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    survey::Random random(seed);
    const Vector3d here = random_place(random, 1),
                   there = here + random_place(random, seed % 2 ? 1 : kStep / 2);
    const double length = (there - here).norm();
    const Vector3d expected = std::min(1.0, kStep / length) * (there - here);
    EXPECT_NEAR((free.towards(here, there) - expected).norm(), 0, 1e-12);
  }
  EXPECT_EQ(free.towards({1, 2, 3}, {1, 2, 3}), Vector3d(0, 0, 0)) << "it is there";
}

TEST(Steering, IsNeverLongerThanTheStepNorNearerThanTheClearance) {
  int bent = 0, still = 0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    survey::Random random(seed);
    Situation situation = corner();
    std::vector<model::SensorPoint> readings(random.below(6));
    for (auto& reading : readings) reading.position = random_place(random, 0.3);
    situation.clearance.remember(readings);
    const Vector3d here = random_place(random, 0.25).cwiseAbs();
    const Vector3d there = random.below(4) ? random_place(random, 0.5) : here;
    const double step = random.uniform(0.1, 2) * kLambda;
    const Vector3d motion = situation.towards(here, there, step);
    ASSERT_TRUE(motion.allFinite());
    ASSERT_LE(motion.norm(), step * (1 + 1e-9));
    const double kept = std::min(situation.clearance.least(), situation.distance(here));
    for (int i = 0; i <= 20; ++i) ASSERT_GE(situation.distance(here + i / 20.0 * motion), kept - 1e-12);
    if (there == here) continue;
    still += motion.isZero();
    bent += !motion.isZero() && motion.normalized().dot((there - here).normalized()) < 0.99;
  }
  EXPECT_GT(bent, 300);
  EXPECT_LT(still, 300);
}

TEST(Steering, LeadsAlongAWall) {
  const Situation floor({{rectangle(-1, -1, 1, 1)}});
  Vector3d here(-0.5, 0, 0.08);
  const Vector3d there(0.5, 0, -0.05);
  for (int i = 0; i < 40 && here.x() < 0.4; ++i) {
    const Vector3d motion = floor.towards(here, there);
    ASSERT_GT(motion.x(), 0) << "step " << i;
    here += motion;
    ASSERT_GE(floor.distance(here), floor.clearance.least() - 1e-12) << "step " << i;
  }
  EXPECT_GE(here.x(), 0.4);
}

TEST(Steering, GetsAwayFromWhatIsTooNear) {
  const Situation situation = corner();
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    survey::Random random(seed);
    const bool at_wall = random.below(2);
    const double off = random.uniform(0.05, 0.95) * situation.clearance.least();
    Vector3d here(random.uniform(-0.5, 0), random.uniform(-0.5, 0.5), off);
    if (at_wall) here.x() = 0.3 - off, here.z() = random.uniform(0.2, 0.5);
    const Vector3d deeper = here + (at_wall ? Vector3d(1, 0, 0) : Vector3d(0, 0, -1));
    for (int i = 0; i < 8 && situation.distance(here) < situation.clearance.least(); ++i) {
      const double before = situation.distance(here);
      here += situation.towards(here, deeper);
      ASSERT_GT(situation.distance(here), before) << "step " << i;
    }
    EXPECT_GE(situation.distance(here), situation.clearance.least());
  }
}

}  // namespace
}  // namespace limpet::following::internal
