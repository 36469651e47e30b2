// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <algorithm>
#include <limpet/evaluation/greedy_cover.hpp>
#include <limpet/evaluation/offline_tour.hpp>
#include <limpet/evaluation/run_judgement.hpp>
#include <limpet/evaluation/short_tour.hpp>
#include <limpet/model/model.hpp>
#include <limpet/simulation/ray_caster.hpp>
#include <limpet/simulation/world.hpp>
#include <limpet/survey/random.hpp>
#include <numeric>

#include "run_worlds.hpp"

namespace limpet::evaluation {
namespace {

using Eigen::Vector3d;
using testing::kClearance;
using testing::kFollowDistance;
using testing::kRange;
using testing::kResolution;
using testing::RunWorld;

// ---- Set cover ---------------------------------------------------------------------------------

using Chosen = std::vector<std::size_t>;

TEST(GreedyCover, TakesWhatGivesMost) {
  EXPECT_EQ(greedy_cover({{0}, {0, 1, 2}, {2, 3}, {3}}, {1, 1, 1, 1}), (Chosen{1, 2}));
  EXPECT_EQ(greedy_cover({{0, 1}, {0, 1}}, {1, 1}), Chosen{0});
  EXPECT_EQ(greedy_cover({}, {1}), Chosen{});
}

TEST(GreedyCover, GivesAsOftenAsIsAsked) {
  EXPECT_EQ(greedy_cover({{0}, {0}, {0}, {0}}, {3}), (Chosen{0, 1, 2}));
  EXPECT_EQ(greedy_cover({{0}, {0, 0}, {0}}, {2}), Chosen{1});  // one that gives twice
  EXPECT_EQ(greedy_cover({{0}, {1}}, {0, 0}), Chosen{});
  EXPECT_EQ(greedy_cover({{0}}, {5, 1}), Chosen{0});  // more than there is
}

TEST(GreedyCover, TakesBackWhatTheOthersGive) {
  // The first gives most, but the two after it are needed for 4 and 5 and give all that it does.
  EXPECT_EQ(greedy_cover({{0, 1, 2, 3}, {0, 1, 4}, {2, 3, 5}}, {1, 1, 1, 1, 1, 1}), (Chosen{1, 2}));
}

TEST(GreedyCover, CoversWhatCanBeAndNothingIsSpare) {
  survey::Random random(17);
  for (int round = 0; round < 50; ++round) {
    Offers offers(30);
    for (auto& offer : offers)
      for (int k = 0; k < 5; ++k) offer.push_back(random.below(20));
    std::vector<int> demand(20), there(20, 0);
    for (int& d : demand) d = static_cast<int>(random.below(4));
    for (const auto& offer : offers)
      for (const std::size_t item : offer) ++there[item];
    const auto lacking = [&](const Chosen& chosen) {
      std::vector<int> rest = demand;
      for (const std::size_t i : chosen)
        for (const std::size_t item : offers[i]) --rest[item];
      int sum = 0;
      for (const int lacks : rest) sum += std::max(0, lacks);
      return sum;
    };
    int least = 0;
    for (std::size_t k = 0; k < demand.size(); ++k) least += std::max(0, demand[k] - there[k]);
    const Chosen chosen = greedy_cover(offers, demand);
    EXPECT_EQ(lacking(chosen), least);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      Chosen fewer = chosen;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
      EXPECT_GT(lacking(fewer), least);
    }
  }
}

// ---- Tours -------------------------------------------------------------------------------------

double legs_of(const ShortTour& tour) { return std::accumulate(tour.legs.begin(), tour.legs.end(), 0.0); }

void expect_visits_all(const ShortTour& tour, std::size_t places) {
  EXPECT_TRUE(tour.lonely.empty());
  ASSERT_EQ(tour.order.size(), places);
  EXPECT_EQ(tour.legs.size() + 1, places);
  EXPECT_EQ(tour.order.front(), 0u);
  Chosen sorted = tour.order;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < places; ++i) EXPECT_EQ(sorted[i], i);
}

TEST(ShortTour, AlongALineIsTheLine) {
  const RunWorld world(testing::cube());
  std::vector<Vector3d> places;
  for (const int k : {0, 7, 3, 9, 1, 5, 8, 2, 6, 4}) places.emplace_back(0.1 * k, 0.5, 1.25);
  const ShortTour tour = short_tour(places, *world.surface, *world.space);
  expect_visits_all(tour, places.size());
  EXPECT_NEAR(legs_of(tour), 0.9, 1e-12);
}

TEST(ShortTour, OverAGridIsNearTheShortest) {
  const RunWorld world(testing::cube());
  std::vector<Vector3d> places;
  for (int i = 0; i < 100; ++i) {
    const int k = i * 37 % 100, row = k / 10, column = k % 10;  // not in their order
    places.emplace_back(0.1 * column, 0.1 * row, 1.25);
  }
  std::swap(places[0], *std::min_element(places.begin(), places.end(),
                                         [](const auto& a, const auto& b) { return a.sum() < b.sum(); }));
  const ShortTour tour = short_tour(places, *world.surface, *world.space);
  expect_visits_all(tour, places.size());
  EXPECT_GE(legs_of(tour), 9.9 - 1e-9);
  EXPECT_LE(legs_of(tour), 9.9 * 1.12);
}

TEST(ShortTour, GoesRoundWhatIsInTheWay) {
  const RunWorld world(simulation::make_shape("thin_plate:0.0625"));
  std::vector<Vector3d> places;
  for (const double z : {0.25, -0.1875})
    for (const double x : {0.4, 0.5, 0.6}) places.emplace_back(x, 0.5, z);
  const ShortTour tour = short_tour(places, *world.surface, *world.space);
  expect_visits_all(tour, places.size());
  EXPECT_GE(legs_of(tour), 0.2 + 1.0 + 0.2);
  EXPECT_LE(legs_of(tour), 2.2);
  for (std::size_t i = 0; i + 1 < tour.order.size(); ++i)
    EXPECT_GE(tour.legs[i], (places[tour.order[i + 1]] - places[tour.order[i]]).norm() - 1e-12);
}

TEST(ShortTour, OfNoOrOnePlace) {
  const RunWorld world(testing::cube());
  EXPECT_TRUE(short_tour({}, *world.surface, *world.space).order.empty());
  EXPECT_EQ(short_tour({{2, 2, 2}}, *world.surface, *world.space).order, Chosen{0});
}

// ---- The yardstick -----------------------------------------------------------------------------

struct Toured {
  RunWorld world;
  Sensing sensing = testing::point_robot_sensing();
  Reachability truth;
  TourOptions options;

  explicit Toured(simulation::Mesh mesh) : world(std::move(mesh)), truth(world.reachable(sensing)) {
    options.start = {-0.3, -0.3, -0.3};
    options.resolution = kResolution;
    options.follow_distance = kFollowDistance;
    options.max_step = kResolution;
  }
  OfflineTour tour() const {
    return offline_tour(world.mesh, *world.surface, *world.space, truth, sensing, options);
  }
};

TEST(OfflineTour, LinksAllThatIsReachable) {
  for (const simulation::Mesh& mesh : {testing::cube(), testing::slotted(0.1875, 0.75)}) {
    const Toured toured(mesh);
    const OfflineTour tour = toured.tour();
    const simulation::RayCaster caster(mesh);
    std::vector<std::vector<Vector3d>> readings(static_cast<std::size_t>(mesh.face_count));
    EXPECT_EQ(tour.positions.size(), tour.sets + 1);
    EXPECT_EQ(tour.positions.front(), toured.options.start);
    for (std::size_t i = 1; i < tour.positions.size(); ++i) {
      EXPECT_EQ(toured.world.space->holds(tour.positions[i]), Verdict::yes);
      for (const Vector3d& axis : toured.sensing.axes)
        if (const auto hit = caster.first_hit(tour.positions[i], axis); hit && hit->range <= kRange)
          readings[static_cast<std::size_t>(hit->face)].push_back(hit->position);
    }
    double missed = 0, reachable = 0;
    for (std::size_t i = 0; i < toured.truth.samples.size(); ++i) {
      if (toured.truth.verdicts[i] != Verdict::yes) continue;
      const SurfaceSample& sample = toured.truth.samples[i];
      const auto& near = readings[static_cast<std::size_t>(sample.face)];
      reachable += sample.area;
      if (std::none_of(near.begin(), near.end(), [&](const Vector3d& reading) {
            return (reading - sample.at).norm() <= 0.9 * kResolution + 1e-12;
          }))
        missed += sample.area;
    }
    EXPECT_NEAR(missed / reachable, tour.unlinked, 1e-9);
    EXPECT_LE(tour.unlinked, 0.001);
  }
}

TEST(OfflineTour, OfACubeTakesTheSetsThatItsAreaAsksFor) {
  Toured toured(testing::cube());
  const OfflineTour tour = toured.tour();
  const double asked = 3 * 6 / (kResolution * kResolution);
  EXPECT_GE(26 * static_cast<double>(tour.sets), asked);
  EXPECT_LE(4 * static_cast<double>(tour.sets), asked);
  EXPECT_GE(tour.path_length, 6);
  double straight = 0;
  for (std::size_t i = 0; i + 1 < tour.positions.size(); ++i)
    straight += (tour.positions[i + 1] - tour.positions[i]).norm();
  EXPECT_GE(tour.path_length, straight - 1e-9);
  EXPECT_LE(static_cast<double>(tour.transit_steps), tour.path_length / kResolution);
  const OfflineTour again = toured.tour();
  EXPECT_EQ(again.positions, tour.positions);
  toured.options.density = 0;  // only that all is linked
  const OfflineTour linking = toured.tour();
  EXPECT_LT(linking.sets, tour.sets / 2);
  EXPECT_LT(linking.path_length, tour.path_length);
  EXPECT_LE(linking.unlinked, 0.001);
}

TEST(OfflineTour, ItsSetsMakeTheModel) {
  const Toured toured(testing::cube());
  const auto world = simulation::make_mesh_world(toured.world.mesh);
  model::Parameters parameters;
  parameters.resolution = kResolution;
  parameters.noise = 0.001;
  model::Model model(parameters);
  FollowingRun run;
  run.path = toured.tour().positions;
  for (const Vector3d& place : run.path) {
    std::vector<model::SensorPoint> readings;
    for (const Vector3d& axis : toured.sensing.axes)
      if (const auto seen = world->sight(place, axis, kRange))
        readings.push_back({place + seen->distance * axis, axis, seen->distance});
    model.update(readings);
  }
  model.finish();
  run.model = model.record();
  RunJudgementOptions options;
  options.resolution = kResolution;
  options.follow_distance = kFollowDistance;
  options.ceiling = kResolution;
  options.sensing = toured.sensing;
  options.tour = true;
  const RunJudgement found = judge_run(toured.world.mesh, run, options);
  EXPECT_EQ(found.coverage, 1);
  EXPECT_TRUE(found.isomorphic) << ::testing::PrintToString(found.topology.report.faults);
  EXPECT_GE(found.clearance.at_positions, kClearance);
  ASSERT_TRUE(found.tour.has_value());
  EXPECT_EQ(found.tour->positions, run.path);
}

TEST(OfflineTour, BeginsBesideAStartThatIsTooNear) {
  Toured toured(testing::cube());
  toured.options.start = {0.5, 0.5, 1.01};
  toured.options.density = 0;
  const OfflineTour tour = toured.tour();
  ASSERT_EQ(tour.positions.size(), tour.sets);
  EXPECT_LE((tour.positions.front() - toured.options.start).norm(), 0.4);
}

}  // namespace
}  // namespace limpet::evaluation
