// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/following/links/joint_watch.hpp>

#include "links_scene.hpp"

namespace limpet::following {
namespace {

using kinematics::Configuration;

/// Tells a robot motions at random; `made`: of each joint, what part of them it makes.
std::vector<std::size_t> found(const Eigen::Vector3d& made, double noise, int sets) {
  survey::Random random(4);
  const kinematics::Robot robot = bars(3);
  JointWatch watch(3);
  Configuration at = Configuration::Zero(3);
  watch.look(at);
  for (int set = 0; set < sets; ++set) {
    Configuration changes(3), measured(3);
    for (double& x : changes) x = random.uniform(-0.05, 0.05);
    watch.told(robot, changes);
    at += made.cwiseProduct(changes);
    for (Eigen::Index k = 0; k < 3; ++k) measured[k] = at[k] + noise * random.normal();
    watch.look(measured);
  }
  return watch.stuck();
}

TEST(JointWatch, FindsTheJointThatDoesNotMove) {
  EXPECT_EQ(found({1, 0, 1}, 0, 60), std::vector<std::size_t>{1});
  EXPECT_EQ(found({0, 1, 0}, 0, 60), (std::vector<std::size_t>{0, 2}));
}

TEST(JointWatch, SuspectsNoJointThatMoves) {
  EXPECT_TRUE(found({1, 1, 1}, 0, 2000).empty());
  EXPECT_TRUE(found({0.5, 1, 0.3}, 0, 2000).empty()) << "slowly";
  EXPECT_TRUE(found({1, 1, 1}, 5e-4, 2000).empty()) << "as noisy encoders say";
}

TEST(JointWatch, AJointThatIsNotToldToMoveIsNotStuck) {
  const kinematics::Robot robot = bars(3);
  JointWatch watch(3);
  for (int set = 0; set < 20; ++set) {
    watch.told(robot, Configuration::Zero(3));
    EXPECT_FALSE(watch.look(Configuration::Zero(3)));
  }
  EXPECT_TRUE(watch.stuck().empty());
}

}  // namespace
}  // namespace limpet::following
