// Copyright the limpet authors. GPL-3.0-or-later.
//
// A linear resolution that grows with the distance to the nearest sensor.
#include <cmath>
#include <limits>
#include <limpet/simulation/shapes.hpp>
#include <stdexcept>

#include "judged_scan.hpp"

namespace limpet::model {
namespace {

using namespace testing;
using Eigen::Vector3d;

/// A floor below a scanner at the origin's height 1.5: rays at equal angles, out to `far`.
Points floor_around(Random& random, double pitch, double far, double noise) {
  Points points;
  const double height = 1.5;
  for (double angle = 0; angle < 6.2831; angle += pitch)
    for (double down = 0.6; height / std::tan(down) < far; down -= pitch) {
      const Vector3d axis(std::cos(angle) * std::cos(down), std::sin(angle) * std::cos(down),
                          -std::sin(down));
      const double range = height / std::sin(down);
      points.push_back({Vector3d(0, 0, height) + (range + noise * random.normal()) * axis, axis, range});
    }
  return points;
}

Parameters growing(double fixed, double per_range, const std::vector<Vector3d>& sensors) {
  Parameters parameters = of_resolution(fixed);
  parameters.resolution_per_range = per_range;
  parameters.sensors = sensors;
  parameters.noise = 0.001;
  parameters.tolerance = 0.01;
  return parameters;
}

TEST(GrowingResolution, AFarFloorIsOnePolygon) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Points points = floor_around(random, 0.0125, 6, 0.001);
    shuffle(points, random);
    const Model model = modelled(growing(0.01, 0.06, {{0, 0, 1.5}}), points);
    EXPECT_EQ(broken_laws(model.record()), "");
    EXPECT_EQ(model.record().polygon_segments.size(), 1u);
    // Rings at the border are farther apart than the λ that suits those near the scanner.
    const Model everywhere = modelled(growing(0.15, 0, {}), points);
    EXPECT_GT(everywhere.record().point_segments.size() + everywhere.record().polygon_segments.size(), 50u);
  }
}

TEST(GrowingResolution, WhatIsNearIsAsFineAsBefore) {
  // A plate with a hole 0.25 wide at 1 from the sensor: five times λ there, less than λ at 6.
  Random random(5);
  Points points;
  for (const auto& p : plate(random, 40'000, 0, 0, 2, 2, 0.001))
    if (std::abs(p.position.x() - 1) > 0.125 || std::abs(p.position.y() - 1) > 0.125) points.push_back(p);
  const auto holes = [&](const Vector3d& sensor) {
    const ModelRecord record = modelled(growing(0.01, 0.04, {sensor}), points).record();
    EXPECT_EQ(record.polygon_segments.size(), 1u);
    return record.polygon_segments.front().cycles.size() - 1;
  };
  EXPECT_EQ(holes({1, 1, 1}), 1u);
  EXPECT_EQ(holes({1, 1, 8}), 0u);
}

TEST(GrowingResolution, CountsFromTheNearestSensor) {
  Random random(6);
  Points points;
  for (const auto& p : plate(random, 40'000, 0, 0, 2, 2, 0.001))
    if (std::abs(p.position.x() - 1) > 0.125 || std::abs(p.position.y() - 1) > 0.125) points.push_back(p);
  const ModelRecord record =
      modelled(growing(0.01, 0.04, {{1, 1, 8}, {-5, 1, 3}, {1, 1, 1}}), points).record();
  EXPECT_EQ(record.polygon_segments.front().cycles.size(), 2u);
}

/// λ grows in proportion: a scene that is twice as large, twice as far away, has the same model.
TEST(GrowingResolution, TwiceAsLargeIsTheSame) {
  Random random(7);
  Points points = floor_around(random, 0.03, 5, 0.001), twice = points;
  for (auto& p : twice) p.position *= 2, p.range *= 2;
  Parameters once = growing(0.01, 0.06, {{0, 0, 1.5}}), larger = once;
  larger.resolution *= 2, larger.noise *= 2, larger.tolerance *= 2, larger.sensors[0] *= 2;
  const ModelRecord a = modelled(once, points).record(), b = modelled(larger, twice).record();
  ASSERT_EQ(a.polygon_segments.size(), b.polygon_segments.size());
  for (std::size_t i = 0; i < a.polygon_segments.size(); ++i) {
    const auto &p = a.polygon_segments[i].cycles, &q = b.polygon_segments[i].cycles;
    ASSERT_EQ(p.size(), q.size());
    for (std::size_t c = 0; c < p.size(); ++c) {
      ASSERT_EQ(p[c].size(), q[c].size());
      for (std::size_t v = 0; v < p[c].size(); ++v) EXPECT_EQ(p[c][v].x, q[c][v].x);
    }
  }
}

TEST(GrowingResolution, ARoomHoldsTheLawsAndGoesOnFromItsState) {
  const simulation::Mesh room = simulation::make_shape("room:3:2:2");
  simulation::ScanOptions options;
  options.order = simulation::ScanOptions::Order::turning;
  options.points = 20'000;
  options.noise = 0.001;
  options.viewpoints = {{2.1, 1.7, 1.5}, {0.4, 3.5, 1.5}};
  Points points;
  for (const auto& p : simulation::scan(room, options)) points.push_back(p.point);
  const Parameters parameters = growing(0.02, 0.14, options.viewpoints);
  Model whole = watched(parameters, points, 50);
  const std::string state = [&] {
    Model half(parameters);
    half.update({points.begin(), points.begin() + 10'400});
    return half.state();
  }();
  Model resumed = Model::from_state(state), other(parameters);
  EXPECT_EQ(resumed.parameters().sensors, parameters.sensors);
  other.update({points.begin(), points.begin() + 10'400});
  for (Model* model : {&resumed, &other}) {
    model->update({points.begin() + 10'400, points.end()});
    model->finish();
  }
  EXPECT_EQ(bytes(resumed.record()), bytes(other.record()));
  EXPECT_EQ(broken_laws(whole.record()), "");
}

TEST(GrowingResolution, RoomsHoldTheLawsHoweverSparse) {
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const simulation::Mesh room = simulation::make_shape("room:" + std::to_string(seed) + ":3:2");
    simulation::ScanOptions options;
    options.order = simulation::ScanOptions::Order::turning;
    options.points = 15'000 * static_cast<std::int64_t>(seed);
    options.noise = 0.001;
    options.seed = seed;
    options.viewpoints = {{2.05, 2.1, 1.6}, {4.1, 1.9, 1.6}};
    Points points;
    for (const auto& p : simulation::scan(room, options)) points.push_back(p.point);
    Random random(seed);
    shuffle(points, random);
    for (const double growth : {0.09, 0.2, 0.25})
      EXPECT_EQ(broken_laws(modelled(growing(0.01, growth, options.viewpoints), points).record()), "")
          << growth;
  }
}

TEST(GrowingResolution, ParametersThatSayNothingAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NO_THROW(Model(growing(0.01, 0.25, {{0, 0, 0}})));
  EXPECT_NO_THROW(Model(growing(0.01, 0, {})));
  EXPECT_THROW(Model(growing(0.01, 0.05, {})), std::invalid_argument) << "no sensor";
  EXPECT_THROW(Model(growing(0.01, 0.05, std::vector<Vector3d>(65, Vector3d::Zero()))),
               std::invalid_argument);
  EXPECT_THROW(Model(growing(0.01, 0.05, {{0, nan, 0}})), std::invalid_argument);
  for (const double growth : {-0.01, 0.26, nan, std::numeric_limits<double>::infinity()})
    EXPECT_THROW(Model(growing(0.01, growth, {{0, 0, 0}})), std::invalid_argument) << growth;
}

}  // namespace
}  // namespace limpet::model
