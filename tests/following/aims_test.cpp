// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/following/frontier/aims_internal.hpp>
#include <limpet/kinematics/robot.hpp>
#include <limpet/survey/random.hpp>

#include "initial_model.hpp"

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;

constexpr double kLambda = 0.05;

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

TEST(Aims, AreNoneThroughASurface) {
  const model::Model model = initial_model({{rectangle(-1, -1, 1, 1)}});
  const kinematics::Robot robot =
      kinematics::point_robot({4 * kLambda, kLambda, Eigen::Quaterniond::Identity()});
  const kinematics::Posture posture(robot, Vector3d(0, 0, 0.1));
  EXPECT_FALSE(choose(model, posture, {{{0, 0, -0.1}, {0, 0, 1}, 1}}));
}

}  // namespace
}  // namespace limpet::following::internal
