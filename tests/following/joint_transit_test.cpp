// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/following/transit/transit_internal.hpp>

#include "links_scene.hpp"

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;
using kinematics::Configuration;
using kinematics::Posture;

/// An arm of three bars before a wall, that goes as its transit tells it.
struct ArmTraveller {
  kinematics::Robot robot;
  model::Model model{model::Parameters{}};
  LinkMotion links{robot, usual_link_parameters(usual_parameters(0.05), Redundancy::programme)};
  std::unique_ptr<Transit> transit = make_joint_transit(links);
  Configuration at;
  double least = 1;  ///< distance from the wall, along the way

  explicit ArmTraveller(const Configuration& start, const kinematics::Robot& made = bars(3))
      : robot(made), at(start) {
    model.add_initial(std::vector<model::InitialFace>{wall(2.3, -0.6, 0.6)});
    arrive();
  }
  Observation seen(const Posture& posture) const { return {model, {}, posture, {}}; }
  void arrive() {
    const Posture posture(robot, at);
    links.look(seen(posture));
    transit->arrive(seen(posture));
  }
  /// Until the transit is over; `moves`: does the robot do what it is told? Returns the number of looks.
  int go(bool moves = true) {
    int looks = 0;
    for (; transit->is_under_way() && looks < 1000; ++looks) {
      const Posture posture(robot, at);
      const Configuration changes = transit->next(seen(posture)).changes;
      least = std::min(least, least_distance(links.guard(), model.view(), at, at + changes));
      if (moves) at += changes;
      arrive();
      const Posture there(robot, at);
      if (transit->is_under_way() && transit->look(seen(there), moves) != Travel::Progress::good)
        transit->stop();
    }
    return looks;
  }
  Vector3d place() const { return Posture(robot, at).control_point(); }
};

const double kLeastOnTheWay =
    0.989 * usual_link_parameters(usual_parameters(0.05), Redundancy::programme).least_distance;

TEST(JointTransit, GoesToAPlaceBehindAWallAndBack) {
  ArmTraveller traveller(Vector3d(1.0, 0, 0));
  const Vector3d start = traveller.place(), under(1.4, -2.2, 0);
  ASSERT_TRUE(traveller.transit->begin_to(under));
  traveller.go();
  EXPECT_LT((traveller.place() - under).norm(), 0.02);
  EXPECT_FALSE(traveller.transit->is_under_way());
  ASSERT_TRUE(traveller.transit->begin([&](const Vector3d& place) { return (place - start).norm() < 1e-6; }));
  traveller.go();
  EXPECT_LT((traveller.place() - start).norm(), 0.02);
  EXPECT_GE(traveller.least, kLeastOnTheWay);
}

/// The arm has one sensor, amid its second bar: it is that which must come before the place.
TEST(JointTransit, GoesWhereASensorOnALinkSeesAPlace) {
  kinematics::Robot robot = bars(3);
  robot.sensors = {{1, {0.5, -0.02, 0}, -Vector3d::UnitY(), 0.2}};
  ArmTraveller traveller(Vector3d(1.0, 0.4, 0.4), robot);
  const Suspicion suspicion{{0.9, -0.9, 0}, Vector3d(0, 1, 0)};
  ASSERT_TRUE(traveller.transit->begin_to_see(suspicion));
  traveller.go();
  const auto sensor = Posture(traveller.robot, traveller.at).sensor(0);
  const Vector3d way = suspicion.at - sensor.position;
  EXPECT_LT((way - way.dot(sensor.axis) * sensor.axis).norm(), 0.02);
  EXPECT_LT(way.dot(sensor.axis), 0.2);
  EXPECT_GE(traveller.least, kLeastOnTheWay);
  EXPECT_FALSE(traveller.transit->begin_to_see({{2.9, 0.9, 0}, Vector3d(-1, 0, 0)})) << "out of reach of it";
}

TEST(JointTransit, BeginsNothingThatIsOutOfReachOrNotVisited) {
  ArmTraveller traveller(Vector3d(1.0, 0, 0));
  EXPECT_FALSE(traveller.transit->begin_to(Vector3d(3.5, 0, 0)));
  EXPECT_FALSE(traveller.transit->begin([](const Vector3d&) { return true; })) << "only where it is";
  EXPECT_FALSE(traveller.transit->is_under_way());
}

TEST(JointTransit, EndsThoughTheRobotStandsStill) {
  ArmTraveller traveller(Vector3d(1.0, 0, 0));
  ASSERT_TRUE(traveller.transit->begin_to(Vector3d(1.4, -2.2, 0)));
  EXPECT_LT(traveller.go(false), 20);
  EXPECT_FALSE(traveller.transit->is_under_way());
}

}  // namespace
}  // namespace limpet::following::internal
