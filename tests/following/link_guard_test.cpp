// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/following/links/link_guard.hpp>
#include <string>

#include "links_scene.hpp"

namespace limpet::following {
namespace {

using Eigen::Vector3d;
using kinematics::Configuration;
using kinematics::Posture;

const LinkParameters kLinks = usual_link_parameters(usual_parameters(0.05), Redundancy::programme);

TEST(LinkGuard, WhatItConnectsIsClearWhereverOneLooks) {
  const std::uint64_t seed = 20261201;
  SCOPED_TRACE("seed " + std::to_string(seed));
  survey::Random random(seed);
  const kinematics::Robot robot = kinematics::arm();
  const LinkGuard guard(robot, kLinks);
  int connected = 0, refused = 0;
  for (int trial = 0; trial < 400; ++trial) {
    model::Model model(model::Parameters{});
    for (int i = 0; i < 2; ++i) add_square(model, random, robots::random_vector(random, 1.5), 0.3);
    const Obstacles obstacles(model.view(), {}, 0);
    const Configuration from = robots::random_configuration(random, robot);
    const Configuration to = from + 0.4 * robots::random_configuration(random, robot);
    const auto clear = [&](const Configuration& at) { return guard.is_clear(Posture(robot, at), obstacles); };
    if (!clear(from) || !clear(to)) continue;
    const bool says = guard.connects(from, to, obstacles);
    ++(says ? connected : refused);
    if (says) {
      EXPECT_GE(least_distance(guard, model.view(), from, to), 0.989 * kLinks.least_distance);
    }
  }
  EXPECT_GT(connected, 20);
  EXPECT_GT(refused, 5);
}

TEST(LinkGuard, ClearIsWhatKeepsLimitsItselfAndTheSurface) {
  kinematics::Robot robot = bars(3);
  const LinkGuard guard(robot, kLinks);
  model::Model model(model::Parameters{});
  model.add_initial(std::vector<model::InitialFace>{wall(2.2, -1, 1)});
  const Obstacles obstacles(model.view(), {}, 0), nothing(model::Model(model::Parameters{}).view(), {}, 0);
  const auto clear = [&](double a, double b, double c) {
    return guard.is_clear(Posture(robot, Eigen::Vector3d(a, b, c)), obstacles);
  };
  EXPECT_FALSE(clear(0, 0, 0)) << "it reaches through the wall";
  EXPECT_TRUE(clear(1.5, 0, 0));
  EXPECT_FALSE(clear(3.1, 0, 0)) << "beyond a limit";
  EXPECT_FALSE(clear(1.5, 2.6, 2.6)) << "it meets itself";
}

TEST(LinkGuard, ReadingsCountAsBalls) {
  kinematics::Robot robot = bars(2);
  const LinkGuard guard(robot, kLinks);
  const model::Model nothing(model::Parameters{});
  const Posture posture(robot, Eigen::Vector2d(0, 0));
  const double beside = 0.02 + kLinks.least_distance;  // from the axis
  for (const double radius : {0.0, 0.05}) {
    const auto clear = [&](double y) {
      return guard.is_clear(posture, Obstacles(nothing.view(), {Vector3d(0.5, y, 0)}, radius));
    };
    EXPECT_TRUE(clear(beside + radius + 1e-6));
    EXPECT_FALSE(clear(beside + radius - 1e-6));
  }
}

TEST(LinkGuard, NoWorseIsWhatComesNoNearer) {
  kinematics::Robot robot = bars(1);
  const LinkGuard guard(robot, kLinks);
  const model::Model nothing(model::Parameters{});
  const Obstacles obstacles(nothing.view(), {Vector3d(0.5, 0.05, 0)}, 0);  // too near at 0
  const auto at = [&](double angle) { return Posture(robot, Configuration::Constant(1, angle)); };
  EXPECT_TRUE(guard.is_no_worse(at(-0.05), at(0), obstacles));
  EXPECT_FALSE(guard.is_no_worse(at(0.02), at(0), obstacles));
  EXPECT_FALSE(guard.is_no_worse(at(0), at(0), obstacles)) << "standing still does not lead away";
  EXPECT_TRUE(guard.is_no_worse(at(-1), at(-1.1), obstacles)) << "nothing is near";
}

}  // namespace
}  // namespace limpet::following
