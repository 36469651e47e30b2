// Copyright the limpet authors. GPL-3.0-or-later.
//
// Thesis §3.3, appendices A and B: gradients against finite differences, beside random polyhedra.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limpet/kinematics/body.hpp>
#include <limpet/kinematics/redundancy.hpp>
#include <limpet/model/model.hpp>
#include <string>

#include "robots.hpp"

namespace limpet::kinematics {
namespace {

using Eigen::Vector3d;

std::uint64_t wanted(const char* variable, std::uint64_t otherwise) {
  const char* text = std::getenv(variable);
  return text ? std::strtoull(text, nullptr, 10) : otherwise;
}

/// A convex polyhedron: a box whose corners are moved a little along a shear, each face with its outside
/// outside.
std::vector<model::InitialFace> random_polyhedron(survey::Random& random, const Vector3d& centre) {
  Eigen::Matrix3d shape = testing::random_pose(random).linear() * random.uniform(0.2, 0.6);
  shape.col(0) += random.uniform(-0.3, 0.3) * shape.col(1);
  std::vector<model::InitialFace> faces;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      std::vector<Vector3d> cycle;
      for (const auto& [u, v] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
        Vector3d p;
        p[axis] = side, p[(axis + 1) % 3] = u * side, p[(axis + 2) % 3] = v;
        cycle.push_back(centre + shape * p);
      }
      faces.push_back({{cycle}});
    }
  return faces;
}

/// A chain whose links have bodies.
Robot robot_with_bodies(survey::Random& random) {
  Robot robot = testing::random_chain(random, 2 + random.below(5));
  for (Link& link : robot.links)
    link.body = {{Vector3d::Zero(), testing::random_vector(random, 0.7), random.uniform(0.01, 0.1)}};
  return robot;
}

/// For each link its nearest point to the model, as the thesis has it.
std::vector<Proximity> nearest_of_links(const Posture& posture, const model::View& view, double reach) {
  std::vector<Proximity> all;
  for (const BodyPart& part : moving_body(posture.robot(), 0)) {
    const model::Capsule capsule = in_world(part, posture);
    if (const auto near = view.nearest(capsule, reach))
      all.push_back({part.link, near->on_surface(capsule.radius), near->at, near->away, near->distance});
  }
  return all;
}

TEST(Redundancy, ReconfigurationIsTheGradientOfTheObjective) {
  const std::uint64_t seed = wanted("LIMPET_SEED", 20261130), trials = wanted("LIMPET_GRADIENTS", 600);
  SCOPED_TRACE("seed " + std::to_string(seed));
  survey::Random random(seed);
  const RedundancyParameters parameters{.gain = 1, .exponent = 6, .influence = 0.8};
  std::uint64_t tried = 0, kinks = 0;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    model::Model model(model::Parameters{});
    model.add_initial(random_polyhedron(random, testing::random_vector(random, 2)));
    const Robot robot = robot_with_bodies(random);
    const Configuration at = testing::random_configuration(random, robot);
    const auto value = [&](const Configuration& q) {
      const Posture posture(robot, q);
      return objective(nearest_of_links(posture, model.view(), 2), parameters);
    };
    const Posture posture(robot, at);
    const auto near = nearest_of_links(posture, model.view(), 2);
    const bool touches =
        std::any_of(near.begin(), near.end(), [](const Proximity& p) { return p.distance < 1e-3; });
    if (near.empty() || touches) continue;  // inside, a distance has no gradient that means anything
    const Eigen::VectorXd z = reconfiguration(posture, near, parameters);
    for (Eigen::Index k = 0; k < at.size(); ++k) {
      const auto slope = [&](double h) {
        Configuration one = at, other = at;
        one[k] += h, other[k] -= h;
        return (value(one) - value(other)) / (2 * h);
      };
      const double fine = slope(1e-5), coarse = slope(1e-4);
      // Where the nearest point jumps from one feature to another the objective has a kink.
      if (std::abs(fine - coarse) > 1e-4 + 0.02 * std::abs(fine)) {
        ++kinks;
        continue;
      }
      ++tried;
      EXPECT_NEAR(-z[k], fine, 1e-6 + 1e-3 * std::abs(fine)) << "trial " << trial << ", joint " << k;
    }
  }
  EXPECT_GT(tried, trials / 2);
  EXPECT_LT(kinks, tried / 5);
}

TEST(Redundancy, TheSecondTermDoesNotMoveTheControlPoint) {
  survey::Random random(5);
  for (int trial = 0; trial < 200; ++trial) {
    const Robot robot = testing::random_chain(random, 4 + random.below(4));
    const Posture posture(robot, testing::random_configuration(random, robot));
    Eigen::VectorXd z(posture.configuration().size());
    for (double& x : z) x = random.uniform(-1, 1);
    const Vector3d motion = testing::random_vector(random, 0.1);
    const Configuration plain = redundant_changes(posture, motion, Eigen::VectorXd::Zero(z.size()), 7000);
    const Configuration changed = redundant_changes(posture, motion, z, 7000);
    EXPECT_LT((posture.jacobian() * (changed - plain)).norm(), 1e-9 * 7000);
    EXPECT_LE(plain.norm(), changed.norm() * (1 + 1e-12)) << "the first term is the smallest solution";
  }
}

TEST(Redundancy, ALinkFartherThanTheInfluenceDoesNotMatter) {
  const Robot arm = testing::planar_arm(3);
  const Posture posture(arm, Eigen::Vector3d(0.1, 0.2, 0.3));
  const RedundancyParameters p{.gain = 1, .exponent = 2, .influence = 0.5};
  const std::vector<Proximity> far = {{2, Vector3d(1, 0, 0), Vector3d(1, 0.5, 0), -Vector3d::UnitY(), 0.5}};
  EXPECT_EQ(objective(far, p), 0);
  EXPECT_EQ(reconfiguration(posture, far, p).norm(), 0);
  const std::vector<Proximity> touching = {{2, Vector3d(1, 0, 0), Vector3d(1, 0, 0), Vector3d::UnitY(), 0}};
  EXPECT_DOUBLE_EQ(objective(touching, p), 0.125 / 2) << "d₀/g at most";
}

/// Appendix B: a switch is moved away from the centre of its field, against the axis.
TEST(Redundancy, SwitchesMoveTheirLinksAgainstTheirAxes) {
  survey::Random random(11);
  for (int trial = 0; trial < 100; ++trial) {
    const Robot robot = testing::random_chain(random, 5);
    const Posture posture(robot, testing::random_configuration(random, robot));
    std::vector<ProximitySwitch> switches;
    for (int i = 0; i < 6; ++i)
      switches.push_back(
          {random.below(5), testing::random_vector(random, 1), testing::random_axis(random), 0.2});
    const std::vector<std::size_t> seeing = {random.below(6)};
    const ProximitySwitch& s = switches[seeing[0]];
    const Eigen::VectorXd z = reconfiguration(posture, switches, seeing, 6);
    const Vector3d axis = posture.link(s.link).linear() * s.axis;
    const Vector3d moves = posture.jacobian(s.link, posture.link(s.link) * s.position) * z;
    EXPECT_LE(moves.dot(axis), 1e-12);
    EXPECT_EQ(reconfiguration(posture, switches, {}, 6).norm(), 0);
    // d = (range/2)²/2 of d₀ = range²/2: three quarters, to the power of five.
    const Eigen::VectorXd expected = std::pow(0.75, 5) *
                                     posture.jacobian(s.link, posture.link(s.link) * s.position).transpose() *
                                     (-0.1 * axis);
    EXPECT_LT((z - expected).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace limpet::kinematics
