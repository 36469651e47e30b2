// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <cmath>
#include <limpet/kinematics/body.hpp>

#include "robots.hpp"

namespace limpet::kinematics {
namespace {

using Eigen::Vector3d;

TEST(Body, LeavesOutWhatNothingMovesAndWhatIsAroundTheControlPoint) {
  Robot robot = testing::planar_arm(3);
  robot.links[0].joint.kind = Joint::Kind::fixed;
  for (Link& link : robot.links) link.body = {{Vector3d::Zero(), Vector3d(1, 0, 0), 0.05}};
  robot.control_point = {2, Vector3d(1, 0, 0)};
  const auto whole = moving_body(robot, 0);
  ASSERT_EQ(whole.size(), 2u);
  EXPECT_EQ(whole[0].link, 1u);
  const auto parts = moving_body(robot, 0.1);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].capsule.b, Vector3d(1, 0, 0)) << "another link is whole";
  EXPECT_TRUE(parts[1].capsule.b.isApprox(Vector3d(0.9, 0, 0)));
  EXPECT_EQ(moving_body(robot, 2).size(), 1u) << "the link is inside the ball";
  robot.control_point.position = Vector3d(0.5, 0, 0);
  EXPECT_EQ(moving_body(robot, 0.1).size(), 3u) << "both ends are left";
}

/// What is left out of the axis is just what is nearer than the radius.
TEST(Body, IsCutWhereItEntersTheBall) {
  survey::Random random(2);
  for (int trial = 0; trial < 300; ++trial) {
    Robot robot = testing::planar_arm(1);
    const Vector3d a = testing::random_vector(random, 1), b = testing::random_vector(random, 1);
    robot.links[0].body = {{a, b, 0.1}};
    robot.control_point = {0, testing::random_vector(random, 1)};
    const double radius = random.uniform(0, 1);
    const auto parts = moving_body(robot, radius);
    for (double t = 0.005; t < 1; t += 0.01) {
      const Vector3d p = a + t * (b - a);
      const double from_ball = (p - robot.control_point.position).norm() - radius;
      if (std::abs(from_ball) < 1e-9) continue;
      bool kept = false;
      for (const BodyPart& part : parts) {
        const double low = (part.capsule.a - a).dot(b - a), high = (part.capsule.b - a).dot(b - a);
        kept |= t * (b - a).squaredNorm() >= low && t * (b - a).squaredNorm() <= high;
      }
      EXPECT_EQ(kept, from_ball > 0) << "trial " << trial << ", at " << t;
    }
  }
}

/// Links with fixed joints between them are one body: what is joined to one of them is joined to all.
TEST(Body, LinksThatAreFixedToEachOtherAreOneBody) {
  Robot robot = testing::planar_arm(4);
  for (Link& link : robot.links) link.body = {{Vector3d(0.3, 0, 0), Vector3d(0.7, 0, 0), 0.05}};
  const auto pairs_of = [](const Robot& r) {
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    const auto body = moving_body(r, 0);
    for (const auto& [i, j] : pairs_to_keep_apart(r, body)) pairs.emplace_back(body[i].link, body[j].link);
    return pairs;
  };
  using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
  EXPECT_EQ(pairs_of(robot), (Pairs{{0, 2}, {0, 3}, {1, 3}}));
  robot.links[2].joint.kind = Joint::Kind::fixed;
  EXPECT_EQ(pairs_of(robot), (Pairs{{0, 3}})) << "1 and 2 are one";
  robot.links[0].body.clear();
  EXPECT_EQ(pairs_of(robot), Pairs{});
}

/// No point of a capsule moves farther than its joints' reach says.
TEST(Body, ReachBoundsHowFarAnyPointMoves) {
  survey::Random random(3);
  for (int trial = 0; trial < 200; ++trial) {
    Robot robot = testing::random_chain(random, 4);
    robot.links[3].body = {{testing::random_vector(random, 1), testing::random_vector(random, 1), 0.2}};
    const Configuration at = testing::random_configuration(random, robot);
    const Posture posture(robot, at);
    const BodyPart part = moving_body(robot, 0).back();
    const Eigen::VectorXd reach = reach_of_joints(part, posture);
    const Vector3d inside = part.capsule.a + random.uniform(0, 1) * (part.capsule.b - part.capsule.a) +
                            random.uniform(0, 0.2) * testing::random_axis(random);
    const Eigen::Matrix3Xd jacobian = posture.jacobian(part.link, posture.link(part.link) * inside);
    for (Eigen::Index k = 0; k < at.size(); ++k) EXPECT_LE(jacobian.col(k).norm(), reach[k] + 1e-12);
  }
}

}  // namespace
}  // namespace limpet::kinematics
