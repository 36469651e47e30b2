// Copyright the limpet authors. GPL-3.0-or-later.
//
// Roadmaps and plans, of a planar arm before walls: what they say is clear is so wherever one looks.
#include <gtest/gtest.h>

#include <limpet/following/links/goal_postures.hpp>
#include <limpet/following/links/halton_internal.hpp>
#include <limpet/following/links/joint_plan.hpp>

#include "links_scene.hpp"

namespace limpet::following {
namespace {

using Eigen::Vector3d;
using kinematics::Configuration;
using kinematics::Posture;

/// An arm of three bars that has looked once, from where it stands.
struct Scene {
  kinematics::Robot robot = bars(3);
  model::Model model{model::Parameters{}};
  LinkMotion links;
  Roadmap roadmap;
  Configuration at;

  Scene(const std::vector<model::InitialFace>& faces, const Configuration& start)
      : links(robot, usual_link_parameters(usual_parameters(0.05), Redundancy::programme)),
        roadmap(links.guard()),
        at(start) {
    if (!faces.empty()) model.add_initial(faces);
    look(start);
  }
  void look(const Configuration& now) {
    at = now;
    const Posture posture(robot, at);
    links.look({model, {}, posture, {}});
    roadmap.arrive(posture, links.obstacles());
  }
  double least(const Configuration& from, const Configuration& to) const {
    return least_distance(links.guard(), model.view(), from, to);
  }
};

const double kLeastOfPlans =
    0.989 * usual_link_parameters(usual_parameters(0.05), Redundancy::programme).least_distance;

TEST(Halton, IsSpreadEvenly) {
  EXPECT_EQ(internal::halton(1, 3), Eigen::Vector3d(1.0 / 2, 1.0 / 3, 1.0 / 5));
  EXPECT_EQ(internal::halton(3, 2), Eigen::Vector2d(3.0 / 4, 1.0 / 9));
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(7);
  constexpr int kPoints = 2000;
  for (int i = 1; i <= kPoints; ++i) mean += internal::halton(i, 7) / kPoints;
  for (const double x : mean) EXPECT_NEAR(x, 0.5, 0.02);
}

TEST(GoalPostures, AreThereAndClear) {
  Scene scene({wall(1.5, -3, 0)}, Vector3d(1.2, 0.3, 0.3));
  int found = 0;
  for (const Vector3d& place : {Vector3d(1.2, -0.5, 0), Vector3d(0.5, 1.8, 0), Vector3d(1.8, 0.6, 0)})
    for (const Configuration& goal : goal_postures(scene.links, scene.roadmap, place)) {
      const Posture posture(scene.robot, goal);
      EXPECT_LT((posture.control_point() - place).norm(), 0.1 * 0.05);
      EXPECT_TRUE(scene.links.guard().is_clear(posture, scene.links.obstacles()));
      EXPECT_GE(scene.least(goal, goal), kLeastOfPlans);
      ++found;
    }
  EXPECT_GE(found, 3);
  EXPECT_TRUE(goal_postures(scene.links, scene.roadmap, Vector3d(4, 0, 0)).empty()) << "out of reach";
  EXPECT_TRUE(goal_postures(scene.links, scene.roadmap, Vector3d(1.49, -1, 0)).empty()) << "in the wall";
}

/// From above a wall's edge to under it: straight in joint space the arm would go through the wall.
TEST(JointPlan, GoesRoundAWall) {
  Scene scene({wall(2.3, -0.6, 0.6)}, Vector3d(1.0, 0, 0));
  const Configuration goal = Vector3d(-1.0, 0, 0);
  ASSERT_FALSE(scene.links.guard().connects(scene.at, goal, scene.links.obstacles()));
  const auto plan = plan_to({goal}, scene.links, scene.roadmap);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->after.back(), goal);
  Configuration from = scene.roadmap.nodes()[plan->from].at;
  EXPECT_EQ(from, scene.at);
  for (const Configuration& to : plan->after) {
    EXPECT_GE(scene.least(from, to), kLeastOfPlans);
    from = to;
  }
  const auto again = plan_to({goal}, scene.links, scene.roadmap);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->after, plan->after);
}

TEST(JointPlan, IsNoneWhereTheGoalIsShutIn) {
  Scene scene({wall(0.3, -3, 3)}, Vector3d(3, 0, 0));  // the arm is on the left of a wall
  EXPECT_FALSE(plan_to({Vector3d(0.1, 0, 0)}, scene.links, scene.roadmap));
}

TEST(Roadmap, LeadsOverWhereTheRobotHasBeen) {
  Scene scene({wall(2.3, -0.6, 0.6)}, Vector3d(1.0, 0, 0));
  const Configuration goal = Vector3d(-1.0, 0, 0);
  const auto plan = plan_to({goal}, scene.links, scene.roadmap);
  ASSERT_TRUE(plan);
  for (const Configuration& to : plan->after)
    while (scene.roadmap.steps(scene.at, to) > 1e-9) {
      const Configuration way = to - scene.at;
      scene.look(scene.at + way * std::min(1.0, 0.1 / way.norm()));
    }
  const std::size_t first = 0;
  const auto way = scene.roadmap.way_to([&](std::size_t i) { return i == first; });
  ASSERT_GT(way.size(), 2u);
  EXPECT_EQ(way.back(), first);
  for (std::size_t i = 1; i < way.size(); ++i) {
    const auto& nodes = scene.roadmap.nodes();
    EXPECT_GE(scene.least(nodes[way[i - 1]].at, nodes[way[i]].at), kLeastOfPlans);
  }
  EXPECT_TRUE(scene.roadmap.way_to([](std::size_t) { return false; }).empty());
}

/// A plan may end where the robot has been.
TEST(Roadmap, AWayThatEndsAtANodeAddsNoOther) {
  Scene scene({}, Vector3d(0, 0.5, 0));
  scene.look(Vector3d(0.3, 0.5, 0));
  const std::size_t first = 0, nodes = scene.roadmap.nodes().size();
  const std::size_t end = scene.roadmap.add_way(scene.roadmap.present(), {Vector3d(0, 0.5, 0)});
  EXPECT_EQ(end, first);
  EXPECT_EQ(scene.roadmap.nodes().size(), nodes);
  const std::size_t fresh = scene.roadmap.add_way(first, {Vector3d(-0.3, 0.5, 0)});
  EXPECT_EQ(scene.roadmap.nodes()[fresh].at, Configuration(Vector3d(-0.3, 0.5, 0)));
}

TEST(Roadmap, AvoidsWhatIsBlocked) {
  Scene scene({}, Vector3d(0, 0.5, 0));
  // A loop in the first two joints, its far end to be reached both ways.
  for (const Vector3d& corner :
       {Vector3d(0.8, 0.5, 0), Vector3d(0.8, 1.3, 0), Vector3d(0, 1.3, 0), Vector3d(0, 0.5, 0)})
    while (scene.roadmap.steps(scene.at, corner) > 1e-9) {
      const Configuration way = corner - scene.at;
      scene.look(scene.at + way * std::min(1.0, 0.1 / way.norm()));
    }
  const auto wanted = [&](std::size_t i) {
    return scene.roadmap.steps(scene.roadmap.nodes()[i].at, Vector3d(0.8, 0.5, 0)) < 0.1;
  };
  const auto way = scene.roadmap.way_to(wanted);
  ASSERT_GT(way.size(), 3u);
  const std::size_t blocked = way[way.size() / 2];
  for (int i = 0; i < 10; ++i) scene.roadmap.block(blocked);
  const auto other = scene.roadmap.way_to(wanted);
  ASSERT_FALSE(other.empty());
  EXPECT_EQ(std::count(other.begin(), other.end(), blocked), 0);
}

}  // namespace
}  // namespace limpet::following
