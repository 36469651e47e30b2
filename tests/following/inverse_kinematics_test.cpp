// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/following/links/inverse_kinematics.hpp>
#include <limpet/kinematics/arm.hpp>
#include <string>

#include "links_scene.hpp"

namespace limpet::following {
namespace {

using Eigen::Vector3d;
using kinematics::Configuration;
using kinematics::Posture;

TaskIn to_place(const Vector3d& place) {
  return [place](const Posture& posture) {
    return control_point_task(posture, place - posture.control_point());
  };
}

TEST(InverseKinematics, LeadsToPlacesWhereTheRobotCanBe) {
  const std::uint64_t seed = 7;
  SCOPED_TRACE("seed " + std::to_string(seed));
  survey::Random random(seed);
  const kinematics::Robot robot = kinematics::arm();
  constexpr double kPrecision = 1e-3;
  int found = 0;
  constexpr int kTrials = 200;
  for (int trial = 0; trial < kTrials; ++trial) {
    Configuration there(6), from(6);
    for (double& joint : there) joint = random.uniform(-1.5, 1.5);
    for (double& joint : from) joint = random.uniform(-1.5, 1.5);
    const Vector3d place = Posture(robot, there).control_point();
    const auto at = led_to(robot, from, to_place(place), kPrecision);
    if (!at) continue;
    ++found;
    EXPECT_LT((Posture(robot, *at).control_point() - place).norm(), kPrecision);
  }
  EXPECT_GT(found, kTrials * 9 / 10);
}

TEST(InverseKinematics, KeepsLimitsAndSaysWhereItDoesNotGet) {
  const kinematics::Robot robot = bars(3);  // within 3 rad
  const Vector3d behind(-2.5, -0.2, 0);     // beyond the first joint's limit, the nearest way
  const auto at = led_to(robot, Vector3d(2.9, 0.1, 0), to_place(behind), 1e-3);
  if (at) {
    for (const double joint : *at) EXPECT_LE(std::abs(joint), 3);
    EXPECT_LT((Posture(robot, *at).control_point() - behind).norm(), 1e-3);
  }
  EXPECT_FALSE(led_to(robot, Vector3d(0.3, 0.3, 0.3), to_place(Vector3d(3.5, 0, 0)), 1e-3)) << "out of reach";
  EXPECT_FALSE(led_to(robot, Vector3d(0.3, 0.3, 0.3), to_place(Vector3d(1, 0, 1)), 1e-3)) << "off its plane";
}

}  // namespace
}  // namespace limpet::following
