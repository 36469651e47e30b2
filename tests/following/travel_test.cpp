// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <functional>
#include <limpet/following/transit/travel_internal.hpp>
#include <string>

#include "initial_model.hpp"
#include "random_places.hpp"

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;

constexpr int kManyLooks = 3000;

/// A robot that makes of each motion, once it is shortened to what is clear, what it will.
struct Traveller {
  model::Model model;
  Clearance clearance{usual_parameters(kLambda).clearance()};
  kinematics::Robot robot = kinematics::point_robot({4 * kLambda, kLambda, Eigen::Quaterniond::Identity()});
  Travel travel{kLambda, kStep};
  Vector3d here = Vector3d::Zero();
  std::function<Vector3d(const Vector3d&)> made = [](const Vector3d& motion) { return motion; };
  int looks = 0, stopped = 0, hopeless = 0, detours = 0;

  /// With nothing near but the faces.
  explicit Traveller(const std::vector<std::vector<Cycle>>& faces = {{rectangle(0, 0, 1, 1, 10)}})
      : model(initial_model(faces)) {}

  void go_to(const Vector3d& place) {
    here = place;
    travel.arrive(model.view(), clearance, here);
  }
  void go_along(const Vector3d& from, const Vector3d& to) {
    const auto steps = static_cast<int>(std::ceil((to - from).norm() / kStep));
    for (int i = 0; i <= steps; ++i) go_to(from + i * (to - from) / std::max(1, steps));
  }
  /// Makes the next motion and looks at it. Precondition: a travel is under way.
  Travel::Progress step() {
    const model::View view = model.view();
    const kinematics::Posture posture(robot, here);
    const Vector3d next = travel.next(Steering(view, clearance, posture, kStep), here);
    const Vector3d motion = made(clearance.shortened(view, here, next));
    go_to(here + motion);
    if (!travel.is_under_way()) return Travel::Progress::good;
    ++looks;
    return travel.look(here, motion.norm() >= 1e-3 * kLambda);
  }
  /// Travels, by `begin` again after each stop, until the travel is over.
  void run(const std::function<bool()>& begin) {
    looks = stopped = hopeless = detours = 0;
    if (!begin()) return;
    while (travel.is_under_way() && looks < kManyLooks) {
      const auto progress = step();
      stopped += progress == Travel::Progress::stopped, hopeless += progress == Travel::Progress::hopeless;
      if (progress == Travel::Progress::good) continue;
      if (progress == Travel::Progress::stopped && travel.go_round(model.view(), clearance)) {
        ++detours;
        continue;
      }
      travel.stop();
      if (progress == Travel::Progress::stopped) begin();
    }
    EXPECT_LT(looks, kManyLooks);
  }
  void run_to_where(const std::function<bool(const Vector3d&)>& wanted) {
    run([&] { return travel.begin(wanted); });
  }
  void run_straight(const Vector3d& to) {
    run([&] { return travel.begin(to), true; });
  }
};

bool is_on_the_left(const Vector3d& p) { return p.x() < 0.01; }

TEST(Travel, ArrivesAtAVisitedPlace) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    survey::Random random(seed);
    Traveller traveller;
    Vector3d from = random_place(random, 0.5), first = from;
    for (int leg = 0; leg < 5; ++leg) {
      const Vector3d to = random_place(random, 0.5);
      traveller.go_along(from, to);
      from = to;
    }
    const double length = (first - from).norm();
    traveller.run_to_where([&](const Vector3d& p) { return (p - first).norm() < kLambda; });
    EXPECT_LT((traveller.here - first).norm(), 1.101 * kLambda) << "a place that is wanted, to a tenth of λ";
    EXPECT_EQ(traveller.stopped + traveller.hopeless, 0);
    EXPECT_LE(traveller.looks, 6 / kStep) << "no longer than the way there, of length " << length;
  }
}

TEST(Travel, BeginsNoWayToWhatWasNotVisited) {
  Traveller traveller;
  EXPECT_FALSE(traveller.travel.begin([](const Vector3d&) { return true; })) << "nothing is visited";
  traveller.go_along({0, 0, 0}, {1, 0, 0});
  EXPECT_FALSE(traveller.travel.begin([](const Vector3d&) { return false; }));
  EXPECT_FALSE(traveller.travel.is_under_way());
}

TEST(Travel, OfALoopTakesTheShorterWay) {
  Traveller traveller;
  for (const auto& [from, to] : {std::pair<Vector3d, Vector3d>{{0, 0, 0}, {0, 1, 0}},
                                 {{0, 1, 0}, {1, 1, 0}},
                                 {{1, 1, 0}, {1, 0, 0}},
                                 {{1, 0, 0}, {0.1, 0, 0}}})
    traveller.go_along(from, to);
  traveller.go_to({0.05, 0, 0});
  traveller.run_to_where([](const Vector3d& p) { return p.y() > 0.99 && p.x() < 0.01; });
  EXPECT_LT((traveller.here - Vector3d(0, 1, 0)).norm(), 0.1 * kLambda);
  EXPECT_LT(traveller.looks, 25);
}

TEST(Travel, ARobotThatDoesNotMoveIsStoppedAtOnceAndGivesUp) {
  Traveller traveller;
  traveller.go_along({0, 0, 0}, {1, 0, 0});
  traveller.made = [](const Vector3d&) { return Vector3d(0, 0, 0); };
  ASSERT_TRUE(traveller.travel.begin(is_on_the_left));
  EXPECT_EQ(traveller.step(), Travel::Progress::stopped);
  traveller.run_to_where(is_on_the_left);
  EXPECT_EQ(traveller.hopeless, 1);
  EXPECT_LT(traveller.looks, 20);
}

TEST(Travel, ARobotThatComesNoNearerIsStopped) {
  Traveller traveller;
  traveller.go_along({0, 0, 0}, {1, 0, 0});
  int motions = 0;
  traveller.made = [&](const Vector3d&) { return Vector3d(0, ++motions % 2 ? kStep : -kStep, 0); };
  ASSERT_TRUE(traveller.travel.begin(is_on_the_left));
  Travel::Progress progress = Travel::Progress::good;
  int looks = 0;
  for (; progress == Travel::Progress::good && looks < 20; ++looks) progress = traveller.step();
  EXPECT_EQ(progress, Travel::Progress::stopped);
  EXPECT_GT(looks, 2) << "one motion may be an evasion";
}

TEST(Travel, ARobotThatCreepsIsGivenUpAfterSomeTimesTheWay) {
  Traveller traveller;
  traveller.go_along({0, 0, 0}, {1, 0, 0});
  traveller.made = [](const Vector3d& motion) { return Vector3d(motion / 8); };
  traveller.run_to_where(is_on_the_left);
  EXPECT_EQ(traveller.hopeless, 1);
  EXPECT_GT(traveller.looks, 20 / kStep * 0.05);
  EXPECT_LE(traveller.looks, 12 + 3 * 1 / kStep + 1);
}

TEST(Travel, EndsWhateverTheRobotDoes) {
  int arrived = 0, given_up = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    survey::Random random(seed);
    const Cycle wall{{0.5, -0.4, -1}, {0.5, 0.4, -1}, {0.5, 0.4, 1}, {0.5, -0.4, 1}};
    Traveller traveller({{wall}});
    traveller.go_along({0, 0, 0}, {0, 0.6, 0});
    traveller.go_along({0, 0.6, 0}, {1, 0.6, 0});
    traveller.go_along({1, 0.6, 0}, {1, 0, 0});
    const double trouble = random.uniform();
    const double still = trouble * random.uniform(), astray = trouble * random.uniform(), back = trouble / 2;
    traveller.made = [&](const Vector3d& motion) -> Vector3d {
      if (random.uniform() < still) return Vector3d::Zero();
      if (random.uniform() < astray) return random_place(random, kStep / 2);
      if (random.uniform() < back) return -motion;
      return motion * random.uniform();
    };
    if (seed % 2)
      traveller.run_to_where(is_on_the_left);
    else
      traveller.run_straight({0, random.uniform(-1, 1), 0});
    EXPECT_FALSE(traveller.travel.is_under_way());
    EXPECT_LE(traveller.hopeless, 1);
    if (!traveller.hopeless) {
      EXPECT_LT(traveller.here.x(), 0.01 + 0.1 * kLambda) << "it has not arrived";
    }
    (traveller.hopeless ? given_up : arrived) += 1;
  }
  EXPECT_GT(arrived, 10);
  EXPECT_GT(given_up, 10);
}

TEST(Travel, AStraightWayArrivesOrEnds) {
  Traveller traveller;
  traveller.go_to({1, 0, 0});
  traveller.run_straight({0, 0, 0});
  EXPECT_NEAR(traveller.here.norm(), 0, 1e-9);
  EXPECT_EQ(traveller.stopped + traveller.hopeless, 0);

  Traveller before_wall({{{{0.5, -1, -1}, {0.5, -1, 1}, {0.5, 1, 1}, {0.5, 1, -1}}}});  // faces −x
  before_wall.go_to({0, 0, 0});
  before_wall.run_straight({0.5, 0, 0});
  EXPECT_EQ(before_wall.hopeless, 1) << "the goal lies on a surface";
  EXPECT_LT(before_wall.here.x(), 0.5);
}

TEST(Travel, GoesRoundWhatHasComeToBeInTheWay) {
  for (const double gap : {0.1, 0.16, 0.2}) {
    SCOPED_TRACE("gap at " + std::to_string(gap));
    Traveller traveller;
    traveller.go_along({0, 0, 0}, {1, 0, 0});
    std::vector<model::SensorPoint> screen;  // with one hole in it, beside the way
    for (double y = -0.4; y <= 0.4; y += kLambda / 2)
      for (double z = -0.4; z <= 0.4; z += kLambda / 2)
        if (const Vector3d p(0.5, y, z); (p - Vector3d(0.5, gap, 0)).norm() > 1.6 * kLambda)
          screen.emplace_back().position = p;
    traveller.clearance.remember(screen);
    traveller.run_to_where(is_on_the_left);
    EXPECT_LT(traveller.here.x(), 0.01 + 0.1 * kLambda);
    EXPECT_GE(traveller.detours, 1);
    EXPECT_EQ(traveller.hopeless, 0);
  }
}

TEST(Travel, IsNotHinderedByAnEarlierOneToTheSamePlace) {
  Traveller traveller;
  for (int round = 0; round < 3; ++round) {
    traveller.go_to({1, 0, 0});
    traveller.run_straight({0, 0, 0});
    EXPECT_NEAR(traveller.here.norm(), 0, 1e-9) << "round " << round;
    EXPECT_EQ(traveller.stopped + traveller.hopeless, 0) << "round " << round;
    traveller.travel.arrived();
  }
}

}  // namespace
}  // namespace limpet::following::internal
