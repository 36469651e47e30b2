// Copyright the limpet authors. GPL-3.0-or-later.
//
// A planar arm that is to see places on a wall: from the postures that are found a sensor does.
#include <gtest/gtest.h>

#include <array>
#include <limpet/following/links/goal_postures.hpp>
#include <vector>

#include "links_scene.hpp"

namespace limpet::following {
namespace {

using Eigen::Vector3d;
using kinematics::Configuration;
using kinematics::Posture;

constexpr double kResolution = 0.05, kRange = 0.2;

/// Three bars before a wall that faces them; a sensor at the end looks on along the last bar, one amid the
/// second bar looks aside.
struct Watcher {
  kinematics::Robot robot = bars(3);
  model::Model model{model::Parameters{}};
  LinkMotion links;
  Roadmap roadmap;

  Watcher()
      : robot(with_sensors(bars(3))),
        links(robot, usual_link_parameters(usual_parameters(kResolution), Redundancy::programme)),
        roadmap(links.guard()) {
    const std::vector<Vector3d> cycle{{2, -1, -1}, {2, -1, 1}, {2, 1, 1}, {2, 1, -1}};
    model.add_initial(std::vector<model::InitialFace>{{{{cycle.rbegin(), cycle.rend()}}}});
    const Posture posture(robot, Vector3d(1.0, 0.5, 0.5));
    links.look({model, {}, posture, {}});
    roadmap.arrive(posture, links.obstacles());
  }
  static kinematics::Robot with_sensors(kinematics::Robot robot) {
    robot.sensors = {{2, Vector3d::UnitX(), Vector3d::UnitX(), kRange},
                     {1, {0.5, -0.02, 0}, -Vector3d::UnitY(), kRange}};
    return robot;
  }
  std::vector<Configuration> sightings(const Suspicion& suspicion, Sight sight, std::size_t sensor) {
    return sighting_postures(links, roadmap, suspicion, sight, std::array{sensor});
  }
};

TEST(SightingPostures, FromThereTheSensorSeesThePlaceAndNoLinkIsTooNear) {
  Watcher watcher;
  int found = 0;
  for (const std::size_t sensor : {0u, 1u})
    for (const double y : {-0.6, -0.2, 0.1, 0.5}) {
      const Suspicion suspicion{{2, y, 0}, -Vector3d::UnitX()};
      for (const Configuration& at : watcher.sightings(suspicion, Sight::sure, sensor)) {
        ++found;
        const Posture posture(watcher.robot, at);
        const auto seen = posture.sensor(sensor);
        const Vector3d way = suspicion.at - seen.position;
        const double along = way.dot(seen.axis);
        EXPECT_LT((way - along * seen.axis).norm(), 0.1 * kResolution + 1e-9);
        EXPECT_GT(along, 0);
        EXPECT_LT(along, kRange - 0.6 * kResolution) << "it would tell that there is nothing";
        EXPECT_GT(-seen.axis.dot(suspicion.normal), 0.25) << "not from behind, nor along the wall";
        EXPECT_TRUE(watcher.links.guard().is_clear(posture, watcher.links.obstacles()));
        EXPECT_GE(least_distance(watcher.links.guard(), watcher.model.view(), at, at),
                  0.999 * watcher.links.parameters().least_distance);
      }
    }
  EXPECT_GE(found, 8);
}

TEST(SightingPostures, NoneSeesWhatFacesAwayOrIsOutOfReachOrBehindTheWall) {
  Watcher watcher;
  for (const Sight sight : {Sight::sure, Sight::faint}) {
    EXPECT_TRUE(watcher.sightings({{2, 0, 0}, Vector3d::UnitX()}, sight, 0).empty()) << "from inside";
    EXPECT_TRUE(watcher.sightings({{3.5, 0, 0}, -Vector3d::UnitX()}, sight, 0).empty()) << "too far";
    EXPECT_TRUE(watcher.sightings({{2.1, 0, 0}, -Vector3d::UnitX()}, sight, 0).empty()) << "covered";
  }
}

/// The arm reaches to 3 + the range along its bars: at the end of the ray a place is seen faintly at most.
TEST(SightingPostures, AtTheEndOfTheRangeAPlaceIsSeenFaintly) {
  Watcher watcher;
  const Suspicion end{{0, 3 + kRange - 0.2 * kResolution, 0}, -Vector3d::UnitY()};
  EXPECT_TRUE(watcher.sightings(end, Sight::sure, 0).empty());
  EXPECT_FALSE(watcher.sightings(end, Sight::faint, 0).empty());
}

/// What the programme leads to keeps clear on the way; the same task, the same answer.
TEST(LinkMotion, IsLedClearToWhatAPointIsToReach) {
  Watcher watcher;
  const Configuration from = Vector3d(1.0, 0.2, 0.2);
  const Vector3d elbow_to = Posture(watcher.robot, Vector3d(0.8, 0.2, 0.2)).link(2).translation();
  const TaskIn elbow = [&](const Posture& posture) {
    const Vector3d at = posture.link(2).translation();
    return Task{elbow_to - at, posture.jacobian(1, at)};
  };
  const auto there = watcher.links.led_clear(from, elbow);
  ASSERT_TRUE(there);
  EXPECT_LT((there->link(2).translation() - elbow_to).norm(), 0.1 * kResolution);
  EXPECT_TRUE(watcher.links.guard().is_clear(*there, watcher.links.obstacles()));
  EXPECT_EQ(watcher.links.led_clear(from, elbow)->configuration(), there->configuration());
  const TaskIn into_wall = [&](const Posture& posture) {
    return control_point_task(posture, Vector3d(2.05, 0, 0) - posture.control_point());
  };
  EXPECT_FALSE(watcher.links.led_clear(Vector3d(1.2, -0.4, -0.6), into_wall));
}

}  // namespace
}  // namespace limpet::following
