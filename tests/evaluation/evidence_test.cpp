// Copyright the limpet authors. GPL-3.0-or-later.
//
// A judge of models by their readings: what is sound passes, and each kind of invention is caught and named.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limpet/evaluation/evidence.hpp>
#include <limpet/model/model.hpp>
#include <limpet/simulation/scan.hpp>
#include <limpet/simulation/scene.hpp>
#include <limpet/survey/random.hpp>
#include <stdexcept>
#include <string>

namespace limpet::evaluation {
namespace {

using Eigen::Vector3d;
using model::SensorPoint;

constexpr double kLambda = 0.0625;
constexpr double kStep = 0x1p-14;
constexpr double kDense = 5;  ///< readings per λ²

/// A rectangle, lengths in λ.
struct Rectangle {
  double x0, y0, x1, y1;
  bool holds(double x, double y) const { return x0 <= x && x <= x1 && y0 <= y && y <= y1; }
  double area() const { return (x1 - x0) * (y1 - y0); }
};

/// A model made by hand, of polygons parallel to the ground that face up, and readings from above.
struct HandMade {
  explicit HandMade(std::uint64_t seed) : random(seed) {
    ::testing::Test::RecordProperty("seed", std::to_string(seed));
    record.grid_step = kStep;
    record.parameters.resolution = kLambda;
    record.parameters.tolerance = kLambda / 5;
  }

  /// A polygon at this height (in λ) whose cycles are closed chains of x, y in λ, interior on the left.
  model::PolygonSegmentRecord& polygon(double height, const std::vector<std::vector<double>>& cycles) {
    model::PolygonSegmentRecord& made = record.polygon_segments.emplace_back();
    made.id = record.next_segment++;
    made.moments.count = 1000;
    made.chart_origin = {0, 0, height * kLambda};
    for (const auto& cycle : cycles) {
      auto& vertices = made.cycles.emplace_back();
      for (std::size_t i = 0; i < cycle.size(); i += 2)
        vertices.push_back(
            {cycle[i] * kLambda / kStep, cycle[i + 1] * kLambda / kStep, record.next_edge++, 0});
    }
    return made;
  }
  model::PolygonSegmentRecord& polygon(double height, const Rectangle& s) {
    return polygon(height, {{s.x0, s.y0, s.x1, s.y0, s.x1, s.y1, s.x0, s.y1}});
  }

  void read(double x, double y, double height) {
    SensorPoint& reading = readings.emplace_back();
    reading.position = Vector3d(x, y, height) * kLambda;
    const Vector3d from = reading.position - sensor * kLambda;
    reading.range = from.norm();
    reading.axis = from / reading.range;
  }

  /// Readings at random over a rectangle, as many per λ² as `density` says.
  void scan(double height, const Rectangle& s, const std::function<double(double, double)>& density,
            double most = kDense) {
    const auto count = std::llround(most * s.area());
    for (long long i = 0; i < count; ++i) {
      const double x = s.x0 + (s.x1 - s.x0) * random.uniform();
      const double y = s.y0 + (s.y1 - s.y0) * random.uniform();
      const double keep = random.uniform(), off = (random.uniform() - 0.5) * 0.2;
      if (keep * most < density(x, y)) read(x, y, height + off);
    }
  }
  void scan(double height, const Rectangle& s, double density = kDense) {
    scan(
        height, s, [density](double, double) { return density; }, density);
  }

  Evidence evidence() const { return judge_evidence(record, readings); }

  survey::Random random;
  model::ModelRecord record;
  std::vector<SensorPoint> readings;
  Vector3d sensor{10, 10, 60};  ///< in λ
};

const Rectangle kPlate{0, 0, 20, 20};

/// The polygons that are unsupported, or transparent.
std::vector<std::uint64_t> named(const Evidence& evidence, bool PolygonEvidence::*what) {
  std::vector<std::uint64_t> ids;
  for (const PolygonEvidence& polygon : evidence.polygons)
    if (polygon.*what) ids.push_back(polygon.id);
  return ids;
}
using Ids = std::vector<std::uint64_t>;

TEST(Evidence, ChanceExplainsTheMoreTheMoreReadings) {
  for (const std::int64_t m : {10, 1000, 100'000, 10'000'000}) {
    const double a = most_by_chance(m);
    EXPECT_NEAR(2 * static_cast<double>(m) * (1 + a) * std::exp(-a), kDiscsByChance, 1e-9);
    EXPECT_GT(most_by_chance(10 * m), a);
  }
  EXPECT_NEAR(most_by_chance(100'000), 20, 0.5);
}

TEST(Evidence, ASoundPlatePasses) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    HandMade judged(seed);
    judged.polygon(0, kPlate);
    judged.scan(0, kPlate);
    const Evidence evidence = judged.evidence();
    EXPECT_TRUE(evidence.within_bounds()) << "seed " << seed;
    EXPECT_EQ(evidence.beyond_chance, 0) << "seed " << seed;
    EXPECT_EQ(evidence.explained, evidence.readings);
    EXPECT_EQ(evidence.readings, 2000);
    EXPECT_NEAR(evidence.polygons[0].density * kLambda * kLambda, kDense, 1);
    EXPECT_GT(evidence.polygons[0].emptiest.expected, 4);
    EXPECT_LT(evidence.empty_area, 0.001 * evidence.polygons[0].area);
    EXPECT_EQ(evidence.rays, 2000);
    EXPECT_EQ(evidence.polygons[0].rays_on, 2000);
  }
}

TEST(Evidence, AnInventedBayIsCaughtAndPlaced) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    HandMade judged(seed);
    judged.polygon(0, {{0, 0, 20, 0, 20, 8, 24, 8, 24, 12, 20, 12, 20, 20, 0, 20}});
    judged.scan(0, kPlate);
    const Evidence evidence = judged.evidence();
    EXPECT_EQ(named(evidence, &PolygonEvidence::unsupported), Ids{1}) << "seed " << seed;
    const EmptyDisc& disc = evidence.polygons[0].emptiest;
    EXPECT_GT(disc.centre.x(), 20 * kLambda);
    EXPECT_NEAR(disc.centre.y(), 10 * kLambda, 2.5 * kLambda);
    EXPECT_NEAR(disc.centre.z(), 0, 1e-12);
    EXPECT_GT(disc.radius, 1.9 * kLambda);
    EXPECT_GT(evidence.empty_area, 6 * kLambda * kLambda);
    EXPECT_LT(evidence.empty_area, 14 * kLambda * kLambda);
    EXPECT_EQ(evidence.emptiest, 0);
  }
}

TEST(Evidence, AFilledHoleIsCaughtAndAKeptOneIsNot) {
  const Rectangle hole{9, 9, 12, 12};
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    HandMade filled(seed);
    filled.scan(0, kPlate, [&](double x, double y) { return hole.holds(x, y) ? 0 : kDense; });
    HandMade kept = filled;
    filled.polygon(0, kPlate);
    kept.polygon(0, {{0, 0, 20, 0, 20, 20, 0, 20}, {9, 9, 9, 12, 12, 12, 12, 9}});
    const Evidence evidence = filled.evidence();
    EXPECT_EQ(named(evidence, &PolygonEvidence::unsupported), Ids{1}) << "seed " << seed;
    EXPECT_LT((evidence.polygons[0].emptiest.centre / kLambda - Vector3d(10.5, 10.5, 0)).norm(), 0.7);
    EXPECT_TRUE(kept.evidence().within_bounds()) << "seed " << seed;
  }
}

TEST(Evidence, ALargeInventionDoesNotExcuseItself) {
  // Fifteen readings, and a polygon of 388 λ² about them.
  HandMade judged(3);
  judged.scan(0, {0, 0, 2, 2}, 15.0 / 4);
  judged.polygon(0, {0, 0, 20, 19.4});
  judged.scan(5, {0, 30, 20, 50});
  judged.polygon(5, {0, 30, 20, 50});
  const Evidence evidence = judged.evidence();
  EXPECT_EQ(named(evidence, &PolygonEvidence::unsupported), Ids{1});
  EXPECT_GT(evidence.polygons[0].emptiest.expected, 100);
}

TEST(Evidence, APolygonWithoutReadingsIsHeldToTheDensityOfTheOthers) {
  HandMade judged(4);
  judged.scan(0, kPlate);
  judged.polygon(0, kPlate);
  judged.polygon(0, {40, 0, 44, 4});
  judged.polygon(0, {50, 0, 51.5, 1.5});  // where chance explains it
  EXPECT_EQ(named(judged.evidence(), &PolygonEvidence::unsupported), Ids{2});
  judged.record.polygon_segments[1].moments.count = 0;  // known beforehand
  const Evidence evidence = judged.evidence();
  EXPECT_TRUE(evidence.within_bounds());
  EXPECT_TRUE(evidence.polygons[1].given);
  EXPECT_LT(evidence.empty_area, 3 * kLambda * kLambda);
}

TEST(Evidence, DensityMayFallAcrossAPolygon) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    HandMade judged(seed);
    const Rectangle wide{0, 0, 60, 20};
    judged.polygon(0, wide);
    judged.scan(
        0, wide, [](double x, double) { return 30 / std::pow(1 + x / 20, 1.5); }, 30);
    EXPECT_TRUE(judged.evidence().within_bounds()) << "seed " << seed;
  }
}

TEST(Evidence, TheResolutionExcusesSmallGapsHoweverDenseTheScan) {
  constexpr double kMany = 100;  // to λ²: chance explains a disc of 0.25 λ
  const auto beside = [](double margin) {
    HandMade judged(15);
    judged.scan(0, kPlate, kMany);
    judged.polygon(0, {-margin, -margin, 20 + margin, 20 + margin});
    return judged.evidence();
  };
  EXPECT_TRUE(beside(0.9).within_bounds());
  EXPECT_TRUE(beside(0.9).polygons[0].emptiest.excused);
  EXPECT_FALSE(beside(1.5).within_bounds());
  const auto filled = [](double width) {
    HandMade judged(16);
    const Rectangle hole{9, 9, 9 + width, 9 + width};
    judged.scan(
        0, kPlate, [&](double x, double y) { return hole.holds(x, y) ? 0 : kMany; }, kMany);
    judged.polygon(0, {-0.7, -0.7, 20.7, 20.7});  // an excused margin hides no hole
    return judged.evidence();
  };
  EXPECT_TRUE(filled(1).within_bounds());
  EXPECT_EQ(named(filled(2.2), &PolygonEvidence::unsupported), Ids{1});
}

TEST(Evidence, RaysThroughAnOpeningContradictThePolygonAcrossIt) {
  // A frame, and a wall behind it that is seen through its opening, but for which the frame's polygon is
  // whole.
  HandMade judged(5);
  const Rectangle opening{6, 6, 14, 14};
  judged.scan(0, kPlate, [&](double x, double y) { return opening.holds(x, y) ? 0 : kDense; });
  judged.polygon(0, kPlate);
  judged.polygon(-10, {0, 0, 20, 20});
  judged.scan(-10, {5, 5, 15, 15}, [&](double x, double y) {
    const double depth = 60.0 / 70;  // where the ray crosses the frame, as seen from above (10, 10)
    return opening.holds(10 + (x - 10) * depth, 10 + (y - 10) * depth) ? kDense : 0;
  });
  const Evidence evidence = judged.evidence();
  EXPECT_EQ(named(evidence, &PolygonEvidence::transparent), Ids{1});
  EXPECT_NEAR(evidence.polygons[0].rays_through, 64 * 5 * std::pow(7.0 / 6, 2), 60) << "in perspective";
  EXPECT_EQ(evidence.polygons[1].rays_through, 0);
  // With the opening kept, nothing is crossed.
  judged.record.polygon_segments[0].cycles.push_back({});
  for (const auto& [x, y] : {std::pair{6, 6}, {6, 14}, {14, 14}, {14, 6}})
    judged.record.polygon_segments[0].cycles.back().push_back(
        {x * kLambda / kStep, y * kLambda / kStep, judged.record.next_edge++, 0});
  EXPECT_EQ(judged.evidence().transparent, 0);
  // Without ranges there is nothing to follow.
  for (SensorPoint& reading : judged.readings) reading.range = 0;
  EXPECT_EQ(judged.evidence().rays, 0);
}

TEST(Evidence, APolygonThatReadingsSupportMayBeTransparentAllTheSame) {
  HandMade judged(6);
  judged.scan(0, kPlate);
  judged.polygon(0, kPlate);
  judged.scan(-10, {8, 8, 12, 12});
  const Evidence evidence = judged.evidence();
  EXPECT_EQ(evidence.unsupported, 0);
  EXPECT_EQ(named(evidence, &PolygonEvidence::transparent), Ids{1});
}

TEST(Evidence, WhatPassesJustBesideAnEdgeIsNoContradiction) {
  // The polygon ends three quarters of λ beyond the plate, before a wall.
  HandMade judged(7);
  judged.scan(0, kPlate);
  judged.polygon(0, {-0.75, -0.75, 20.75, 20.75});
  judged.scan(-10, {-20, -20, 40, 40}, [](double x, double y) {
    const double depth = 60.0 / 70;
    return kPlate.holds(10 + (x - 10) * depth, 10 + (y - 10) * depth) ? 0 : kDense;
  });
  EXPECT_EQ(judged.evidence().transparent, 0);
}

TEST(Evidence, OutliersContradictNothing) {
  HandMade judged(8);
  judged.scan(0, kPlate);
  judged.polygon(0, kPlate);
  for (int i = 0; i < 60; ++i)
    judged.read(20 * judged.random.uniform(), 20 * judged.random.uniform(), -40 * judged.random.uniform());
  const Evidence evidence = judged.evidence();
  EXPECT_TRUE(evidence.within_bounds());
  EXPECT_LT(evidence.explained_share(), 0.98);
}

TEST(Evidence, ExplainedIsTheShareOnThePolygonsOnTheirSide) {
  HandMade judged(9);
  judged.scan(0, kPlate);
  judged.polygon(0, kPlate);
  judged.scan(10, {0, 0, 10, 10});  // off it: 500 more
  EXPECT_NEAR(judged.evidence().explained_share(), 0.8, 1e-12);
  for (SensorPoint& reading : judged.readings) reading.axis = -reading.axis;
  EXPECT_EQ(judged.evidence().explained, 0);
}

TEST(Evidence, CopiesCountOnceAndOrderDoesNotMatter) {
  HandMade judged(10);
  judged.scan(0, kPlate);
  judged.polygon(0, {0, 0, 23, 20});
  const Evidence once = judged.evidence();
  const std::vector<SensorPoint> copies = judged.readings;
  judged.readings.insert(judged.readings.end(), copies.rbegin(), copies.rend());
  std::rotate(judged.readings.begin(), judged.readings.begin() + 777, judged.readings.end());
  const Evidence twice = judged.evidence();
  EXPECT_EQ(once.readings, twice.readings);
  EXPECT_EQ(once.polygons[0].readings, twice.polygons[0].readings);
  EXPECT_EQ(once.polygons[0].density, twice.polygons[0].density);
  EXPECT_EQ(once.polygons[0].emptiest.expected, twice.polygons[0].emptiest.expected);
  EXPECT_EQ(once.polygons[0].emptiest.centre, twice.polygons[0].emptiest.centre);
  EXPECT_EQ(once.empty_area, twice.empty_area);
}

TEST(Evidence, FewReadingsAndPolygonsWithoutAreaAreJudgedToo) {
  HandMade judged(11);
  EXPECT_TRUE(judged.evidence().within_bounds()) << "nothing at all";
  judged.polygon(0, kPlate);
  EXPECT_TRUE(judged.evidence().within_bounds()) << "no density is known";
  judged.polygon(0, {{0, 0, 1, 0}});
  for (int i = 0; i < 3; ++i) {  // one, two, three in a line
    judged.read(2 + i, 2, 0);
    EXPECT_EQ(judged.evidence().readings, i + 1);
  }
  judged.record.parameters.resolution = 0;
  EXPECT_THROW(judged.evidence(), std::invalid_argument);
}

/// A simulated scan, shuffled, with noise, and the model that limpet makes of it.
struct Modelled {
  explicit Modelled(const std::string& shape, double resolution, std::uint64_t seed) {
    const simulation::Scene scene = simulation::make_scene(shape);
    simulation::ScanOptions options;
    options.points = 30'000;
    options.noise = 0.001;
    options.seed = seed;
    options.order = simulation::ScanOptions::Order::shuffled;
    options.viewpoints = scene.viewpoints;
    for (const auto& labelled : simulation::scan(scene.mesh, options)) readings.push_back(labelled.point);
    model::Parameters parameters;
    parameters.resolution = resolution;
    parameters.noise = options.noise;
    parameters.tolerance = std::max(3 * options.noise, resolution / 5);
    model::Model model(parameters);
    for (std::size_t i = 0; i < readings.size(); i += 26)
      model.update({readings.data() + i, std::min<std::size_t>(26, readings.size() - i)});
    model.finish();
    record = model.record();
  }
  model::ModelRecord record;
  std::vector<SensorPoint> readings;
};

TEST(Evidence, ModelsOfSimulatedScansPass) {
  constexpr std::uint64_t kSeed = 12;
  RecordProperty("seed", std::to_string(kSeed));
  for (const auto& [shape, resolution] :
       {std::pair{"cube", 0.04}, {"L", 0.04}, {"step_hole", 0.04}, {"plate3", 0.04}, {"open_box", 0.04}}) {
    const Modelled modelled(shape, resolution, kSeed);
    const Evidence evidence = judge_evidence(modelled.record, modelled.readings);
    EXPECT_TRUE(evidence.within_bounds()) << shape;
    EXPECT_GT(evidence.explained_share(), 0.98) << shape;
    ASSERT_GE(evidence.emptiest, 0) << shape;
    EXPECT_LT(evidence.polygons[evidence.emptiest].emptiest.expected, evidence.chance) << shape;
  }
}

TEST(Evidence, WhatIsInventedInAModelIsNamed) {
  Modelled modelled("plate3", 0.04, 13);
  RecordProperty("seed", "13");
  Ids pierced;
  for (model::PolygonSegmentRecord& polygon : modelled.record.polygon_segments) {
    if (polygon.cycles.size() < 2) continue;
    pierced.push_back(polygon.id);
    polygon.cycles.resize(1);
  }
  ASSERT_EQ(pierced.size(), 2u) << "the plate's two sides";
  EXPECT_EQ(named(judge_evidence(modelled.record, modelled.readings), &PolygonEvidence::unsupported),
            pierced);
}

}  // namespace
}  // namespace limpet::evaluation
