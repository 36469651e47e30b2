// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/following/frontier/aims_internal.hpp>
#include <limpet/kinematics/robot.hpp>
#include <limpet/survey/random.hpp>

#include "initial_model.hpp"
#include "random_places.hpp"

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;

/// A small face above the plane z = 0, on both sides of which there is room.
Cycle hidden_by() { return rectangle(0.03, -1, 0.06, 2, 0.2); }

/// The aim of a control point at `posture` that knows of these targets, and of nothing else.
std::optional<Aim> choose(const model::Model& model, const kinematics::Posture& posture,
                          const std::vector<Target>& targets) {
  const Parameters parameters = usual_parameters(kLambda);
  Outlook outlook;
  outlook.targets = targets;
  ExpectedPlanes planes(kLambda, outlook);
  return AimChooser(parameters, posture, kLambda)
      .choose(model.view(), Clearance(parameters.clearance()), targets, planes);
}

TEST(Aims, PutAnAxisThroughTheTargetAndAreSafe) {
  survey::Random random(3);
  const model::Model model = initial_model({{rectangle(0, 0, 1, 1)}});
  const Clearance clearance(usual_parameters(kLambda).clearance());
  int found = 0;
  for (int round = 0; round < 50; ++round) {
    const Eigen::Quaterniond heading(random.normal(), random.normal(), random.normal(), random.normal());
    const kinematics::Robot robot = kinematics::point_robot({4 * kLambda, kLambda, heading});
    const Vector3d here(1, random.uniform(0.2, 0.8), 0.1);
    const kinematics::Posture posture(robot, here);
    const std::vector<Target> targets{{{1.04, random.uniform(0.2, 0.8), 0}, {0, 0, 1}, 1}};
    const auto aim = choose(model, posture, targets);
    if (!aim) continue;
    ++found;
    const Vector3d way = aim->target.at - aim->place;
    double best = 0;
    for (std::size_t i = 0; i < robot.sensors.size(); ++i)
      best = std::max(best, posture.sensor(i).axis.dot(way.normalized()));
    EXPECT_NEAR(best, 1, 1e-9);
    EXPECT_LE(way.norm(), 4 * kLambda);
    EXPECT_TRUE(clearance.is_clear(model.view(), here, aim->place));
  }
  EXPECT_GT(found, 40);
}

TEST(Aims, PreferAPlaceFromWhichMoreTargetsAreMet) {
  const model::Model model = initial_model({{rectangle(-1, 0, 0, 1)}});
  const kinematics::Robot robot =
      kinematics::point_robot({4 * kLambda, kLambda, Eigen::Quaterniond::Identity()});
  const Vector3d here(0.05, 0.5, 0.11);
  const kinematics::Posture posture(robot, here);
  const std::vector<Target> one{{{0.05, 0.52, 0}, {0, 0, 1}, 1}};
  std::vector<Target> many = one;
  for (const double y : {0.42, 0.62}) many.push_back({{0.05, y, 0}, {0, 0, 1}, 1});
  const auto alone = choose(model, posture, one), among = choose(model, posture, many);
  ASSERT_TRUE(alone && among);
  EXPECT_GT(among->value, alone->value);
}

TEST(Aims, PreferAPlaceFromWhichNewGroundIsMet) {
  const model::Model model = initial_model({{rectangle(-1, 0, 0, 1)}});
  const kinematics::Robot robot =
      kinematics::point_robot({4 * kLambda, kLambda, Eigen::Quaterniond::Identity()});
  const kinematics::Posture posture(robot, Vector3d(0.05, 0.5, 0.11));
  const Parameters parameters = usual_parameters(kLambda);
  AimChooser chooser(parameters, posture, kLambda);
  Outlook outlook;
  outlook.targets = {{{0.0425, 0.5, 0}, {0, 0, 1}, 1}};
  outlook.borders = {{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, true}};
  ExpectedPlanes open(kLambda, outlook);
  outlook.borders[0].goes_on = false;
  ExpectedPlanes ended(kLambda, outlook);
  const Clearance clearance(parameters.clearance());
  const auto on_open = chooser.choose(model.view(), clearance, outlook.targets, open),
             on_ended = chooser.choose(model.view(), clearance, outlook.targets, ended);
  ASSERT_TRUE(on_open && on_ended);
  EXPECT_GT(on_open->value, on_ended->value);
}

/// A sensor that looks past the control point from behind, or down from beside it.
TEST(Aims, LookFromWhereTheSensorIsMounted) {
  const model::Model model = initial_model({{rectangle(-1, 0, 0, 1)}, {hidden_by()}});
  kinematics::Robot robot = kinematics::point_robot({4 * kLambda, kLambda, Eigen::Quaterniond::Identity()});
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    survey::Random random(seed);
    for (auto& sensor : robot.sensors) {
      sensor.position = random_place(random, kLambda);
      if (random.below(3) == 0) sensor.position -= random.uniform(0, 4 * kLambda) * sensor.axis;
    }
    const Vector3d here(0.05, random.uniform(0.2, 0.8), random.uniform(0.08, 0.15));
    const Target target{{0.0425, here.y(), 0}, {0, 0, 1}, 1};
    const auto aim = choose(model, kinematics::Posture(robot, here), {target});
    if (!aim) continue;
    ++found;
    const Vector3d from = aim->place + aim->sensor, way = target.at - from;
    EXPECT_FALSE(model.view().first_hit(from, way, way.norm() - kLambda));
    double best = 0;
    for (const auto& sensor : robot.sensors)
      if ((sensor.position - aim->sensor).norm() < 1e-9) best = sensor.axis.dot(way.normalized());
    EXPECT_NEAR(best, 1, 1e-9);
  }
  EXPECT_GT(found, 50);
}

TEST(Aims, AreNoneThroughASurface) {
  const model::Model model = initial_model({{rectangle(-1, -1, 1, 1)}});
  const kinematics::Robot robot =
      kinematics::point_robot({4 * kLambda, kLambda, Eigen::Quaterniond::Identity()});
  const kinematics::Posture posture(robot, Vector3d(0, 0, 0.1));
  EXPECT_FALSE(choose(model, posture, {{{0, 0, -0.1}, {0, 0, 1}, 1}}));
}

}  // namespace
}  // namespace limpet::following::internal
