// Copyright the limpet authors. GPL-3.0-or-later.
//
// Arms beside walls, asked for motions at random: what the programme lets them do is clear wherever one
// looks.
#include <gtest/gtest.h>

#include <cmath>
#include <limpet/following/links/link_motion.hpp>
#include <limpet/kinematics/arm.hpp>
#include <limpet/model/model.hpp>
#include <string>

#include "links_scene.hpp"

namespace limpet::following {
namespace {

using Eigen::Vector3d;
using kinematics::Configuration;
using kinematics::Posture;

/// The distance of each part from the model, as far as `reach`, along some places of a way.
std::vector<double> least_distances(const kinematics::Robot& robot,
                                    const std::vector<kinematics::BodyPart>& body, const model::View& view,
                                    const Configuration& from, const Configuration& changes, int places) {
  std::vector<double> least(body.size(), 1);
  for (int i = 0; i <= places; ++i) {
    const Posture posture(robot, from + changes * (static_cast<double>(i) / places));
    for (std::size_t k = 0; k < body.size(); ++k)
      if (const auto near = view.nearest(kinematics::in_world(body[k], posture), 1))
        least[k] = std::min(least[k], near->distance);
  }
  return least;
}

Configuration bent(survey::Random& random) {
  Configuration at(6);
  for (double& joint : at) joint = random.uniform(-1.5, 1.5);
  return at;
}

TEST(LinkMotion, TheProgrammeKeepsLinksOffWhateverIsAsked) {
  const std::uint64_t seed = 20261130;
  SCOPED_TRACE("seed " + std::to_string(seed));
  survey::Random random(seed);
  const kinematics::Robot robot = kinematics::arm();
  const Parameters parameters = usual_parameters(0.05);
  const LinkParameters links = usual_link_parameters(parameters, Redundancy::programme);
  const auto body = kinematics::moving_body(robot, links.spared);
  int moved = 0, steps = 0;
  for (int trial = 0; trial < 12; ++trial) {
    Configuration at = bent(random);
    model::Model model(model::Parameters{});
    for (int i = 0; i < 3; ++i)
      add_square(model, random, Posture(robot, at).control_point() + robots::random_vector(random, 1));
    LinkMotion motion(robot, links);
    const Vector3d way = robots::random_axis(random);
    for (int step = 0; step < 40; ++step, ++steps) {
      const Posture posture(robot, at);
      motion.look({model, {}, posture, {}});
      const Configuration changes = motion.changes(0.05 * way);
      EXPECT_LE(changes.norm(), robot.ceilings.revolute_rad * (1 + 1e-12));
      const auto start = least_distances(robot, body, model.view(), at, 0 * changes, 1);
      const auto least = least_distances(robot, body, model.view(), at, changes, 20);
      const auto end = least_distances(robot, body, model.view(), at + changes, 0 * changes, 1);
      for (std::size_t k = 0; k < body.size(); ++k) {
        EXPECT_GE(least[k], std::min(links.least_distance, start[k]) - 0.011 * links.least_distance)
            << "trial " << trial << ", step " << step;
        if (start[k] < links.least_distance && changes.norm() > 0) {
          EXPECT_GT(end[k], start[k]);
        }
      }
      moved += (posture.jacobian() * changes).dot(way) > 0.005;
      at += changes;
    }
  }
  EXPECT_GT(moved, steps / 3) << "it goes on as long as it can";
}

TEST(LinkMotion, FarFromEverythingBothMoveTheControlPointAsAsked) {
  survey::Random random(4);
  const kinematics::Robot robot = kinematics::arm();
  const model::Model nothing{model::Parameters{}};
  for (const Redundancy redundancy : {Redundancy::programme, Redundancy::thesis}) {
    for (int trial = 0; trial < 50; ++trial) {
      const Configuration at = bent(random);
      const Posture posture(robot, at);
      LinkMotion motion(robot, usual_link_parameters(usual_parameters(0.05), redundancy));
      const Vector3d wanted = 0.02 * robots::random_axis(random);
      motion.look({nothing, {}, posture, {}});
      const Configuration changes = motion.changes(wanted);
      const Vector3d made = posture.jacobian() * changes;
      EXPECT_GT(made.dot(wanted), 0.5 * made.norm() * wanted.norm());
      if (changes.norm() < 0.9 * robot.ceilings.revolute_rad) {
        EXPECT_LT((made - wanted).norm(), 0.1 * wanted.norm());
      }
    }
  }
}

/// A reading that the model does not have yet is an obstacle like the model.
TEST(LinkMotion, ReadingsAreObstaclesAtOnce) {
  kinematics::Robot robot;
  robot.links.resize(1);
  robot.links[0].joint = {kinematics::Joint::Kind::prismatic, Vector3d::UnitX()};
  robot.links[0].body = {{Vector3d(0, 0, 0.5), Vector3d(0, 0, 1), 0.01}};
  robot.ceilings.prismatic = 0.1;
  const model::Model nothing{model::Parameters{}};
  LinkMotion motion(robot, usual_link_parameters(usual_parameters(0.05), Redundancy::programme));
  Configuration at = Configuration::Zero(1);
  const std::vector<model::SensorPoint> readings = {{Vector3d(0.2, 0, 0.7), Vector3d::UnitX()}};
  for (int step = 0; step < 30; ++step) {
    const Posture posture(robot, at);
    motion.look({nothing, {}, posture, step == 0 ? readings : std::vector<model::SensorPoint>{}});
    at += motion.changes(Vector3d(0.05, 0, 0));
  }
  EXPECT_LE(at[0], 0.2 - 0.01 - 0.1 + 1e-3);
  EXPECT_GT(at[0], 0.07) << "it comes as near as it may";
}

/// What is judged to be reached is reached, as long as nothing new is sensed.
TEST(LinkMotion, WhatItReachesItReaches) {
  survey::Random random(12);
  const kinematics::Robot robot = kinematics::arm();
  const LinkParameters links = usual_link_parameters(usual_parameters(0.05), Redundancy::programme);
  int yes = 0, no = 0;
  for (int trial = 0; trial < 60; ++trial) {
    Configuration at = bent(random);
    model::Model model(model::Parameters{});
    const Vector3d here = Posture(robot, at).control_point();
    for (int i = 0; i < 3; ++i) add_square(model, random, here + robots::random_vector(random, 1));
    LinkMotion motion(robot, links);
    const Vector3d place = here + 0.2 * robots::random_axis(random);
    const Posture start(robot, at);
    motion.look({model, {}, start, {}});
    const auto reached = motion.reaching(place);
    if (!reached) {
      ++no;
      continue;
    }
    ++yes;
    EXPECT_LT((reached->control_point() - place).norm(), 0.01);
    for (int step = 0; step < 12; ++step) {
      const Posture posture(robot, at);
      motion.look({model, {}, posture, {}});
      const Vector3d way = place - posture.control_point();
      at += motion.changes(way.norm() > 0.1 ? Vector3d(0.1 * way.normalized()) : way);
    }
    EXPECT_LT((Posture(robot, at).control_point() - place).norm(), 0.01) << "trial " << trial;
  }
  EXPECT_GT(yes, 10);
  EXPECT_GT(no, 5);
}

/// Of a switch that sees what the model does not have: by the programme it comes no nearer to the centre of
/// its field, and by the thesis its link is led away from it where joints are left over.
TEST(LinkMotion, WhatASwitchSeesIsNotNeared) {
  survey::Random random(12);
  const kinematics::Robot robot = kinematics::with_switches(kinematics::arm());
  const model::Model nothing{model::Parameters{}};
  int wanted_nearer = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Configuration at = bent(random);
    const Posture posture(robot, at);
    const std::vector<std::size_t> seeing = {random.below(robot.switches.size())};
    const Posture::Switch s = posture.proximity_switch(seeing[0]);
    const Eigen::RowVectorXd nears =
        s.axis.transpose() * posture.jacobian(robot.switches[seeing[0]].link, s.position);
    const Vector3d wanted = 0.02 * robots::random_axis(random);
    const auto changes = [&](Redundancy redundancy, std::span<const std::size_t> seen) -> Configuration {
      LinkMotion motion(robot, usual_link_parameters(usual_parameters(0.05), redundancy));
      motion.look({nothing, {}, posture, {}, seen});
      return motion.changes(wanted);
    };
    EXPECT_LE(nears.dot(changes(Redundancy::programme, seeing)), 1e-9) << "trial " << trial;
    wanted_nearer += nears.dot(changes(Redundancy::programme, {})) > 1e-4;
    const Configuration led = kinematics::redundant_changes(
        posture, Vector3d::Zero(), kinematics::reconfiguration(posture, robot.switches, seeing, 6), 7000);
    EXPECT_LE(nears.dot(led), 1e-9) << "the second term of (3)";
    const Configuration by_thesis = changes(Redundancy::thesis, seeing);
    EXPECT_LT((by_thesis -
               kinematics::limited(posture, led + kinematics::redundant_changes(
                                                      posture, wanted, Eigen::VectorXd::Zero(at.size()), 1)))
                  .norm(),
              1e-9);
  }
  EXPECT_GT(wanted_nearer, 40) << "without the switch it would be neared";
}

TEST(LinkMotion, TheSameCallsGiveTheSameChanges) {
  survey::Random random(8);
  const kinematics::Robot robot = kinematics::arm();
  model::Model model(model::Parameters{});
  const Configuration at = bent(random);
  add_square(model, random, Posture(robot, at).control_point() + Vector3d(0.1, 0.1, 0.1));
  const auto run = [&] {
    LinkMotion motion(robot, usual_link_parameters(usual_parameters(0.05), Redundancy::programme));
    Configuration now = at;
    for (int i = 0; i < 20; ++i) {
      const Posture posture(robot, now);
      motion.look({model, {}, posture, {}});
      now += motion.changes(Vector3d(0.01, 0.02, -0.03));
    }
    return now;
  };
  EXPECT_EQ(run(), run());
}

/// To the second order, no end of a link goes farther than λ into space that no ray went through and no link
/// was in; where all is sensed it goes as far as its ceilings let it.
TEST(LinkMotion, StepsIntoTheUnknownAreShort) {
  kinematics::Robot robot = bars(3);
  robot.ceilings.revolute_rad = 0.3;
  const Parameters parameters = usual_parameters(0.05);
  const model::Model nothing{model::Parameters{}};
  const auto body = kinematics::moving_body(robot, 2 * parameters.resolution);
  const auto farthest = [&](const Configuration& from, const Configuration& to) {
    double longest = 0;
    for (const auto& part : body) {
      const model::Capsule a = kinematics::in_world(part, Posture(robot, from)),
                           b = kinematics::in_world(part, Posture(robot, to));
      longest = std::max({longest, (b.a - a.a).norm(), (b.b - a.b).norm()});
    }
    return longest;
  };
  LinkMotion motion(robot, usual_link_parameters(parameters, Redundancy::programme));
  const Configuration start = Vector3d(0, 0, 0), end = Vector3d(1, 0, 0);
  Configuration at = start;
  int steps = 0;
  for (; (end - at).norm() > 1e-9 && steps < 100; ++steps) {
    motion.look({nothing, {}, Posture(robot, at), {}});
    const Configuration next = at + motion.towards(end);
    EXPECT_LE(farthest(at, next), 1.01 * parameters.resolution);
    at = next;
  }
  EXPECT_LT(steps, 100) << "it gets there";
  motion.look({nothing, {}, Posture(robot, at), {}});
  EXPECT_GT(farthest(at, at + motion.towards(start)), 2 * parameters.resolution) << "back it knows its way";
}

}  // namespace
}  // namespace limpet::following
