// Copyright the limpet authors. GPL-3.0-or-later.
//
// How noise goes with range, as the scan tells it.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limpet/simulation/scan.hpp>
#include <limpet/simulation/scene.hpp>
#include <limpet/survey/estimate.hpp>
#include <limpet/survey/noise_law.hpp>
#include <limpet/survey/random.hpp>

#include "estimates.hpp"

namespace limpet::survey {
namespace {

/// Neighbourhoods at ranges from 0.5 to 3, whose estimates scatter by a tenth; a part of them cross edges.
std::vector<NoiseAt> neighbourhoods(const NoiseLaw& truth, double across_edges, std::uint64_t seed) {
  Random random(seed);
  std::vector<NoiseAt> found;
  for (int i = 0; i < 1000; ++i) {
    const double range = random.uniform(0.5, 3);
    double noise = truth.at(range) * (1 + 0.1 * random.normal());
    if (random.uniform() < across_edges) noise += random.uniform(0, 10 * truth.at(range));
    found.push_back({range, noise});
  }
  return found;
}

TEST(NoiseLaw, IsFoundAgain) {
  const NoiseLaw laws[] = {{0.01, 0, 0}, {0, 0.004, 0}, {0, 0, 0.0015}, {0.002, 0.004, 0}, {0.001, 0, 0.002}};
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    for (const NoiseLaw& truth : laws) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", noise " + short_text(truth));
      for (const double across_edges : {0.0, 0.3}) {
        const NoiseLaw found = fit_noise_law(neighbourhoods(truth, across_edges, seed));
        EXPECT_EQ(found.varies(), truth.varies());
        for (const double range : {0.6, 1.5, 2.8})
          EXPECT_NEAR(found.at(range), truth.at(range), 0.25 * truth.at(range)) << "range " << range;
      }
    }
  }
}

TEST(NoiseLaw, IsOneNumberWhereRangesAreNotKnownOrAllTheSame) {
  std::vector<NoiseAt> unknown, same;
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    unknown.push_back({0, random.uniform(0.001, 0.002)});
    same.push_back({random.uniform(1, 1.1), random.uniform(0.001, 0.002)});
  }
  EXPECT_FALSE(fit_noise_law(unknown).varies());
  EXPECT_FALSE(fit_noise_law(same).varies());
  EXPECT_EQ(fit_noise_law({}).fixed, 0);
}

/// A sensor that knows its directions less well than its ranges: readings scatter about a surface by
/// σ cos + δ sin of the incidence.
TEST(NoiseLaw, IsRaisedToWhatReadingsScatterByAtAGrazingAngle) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    for (const double delta : {0.0, 0.001, 0.003}) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", by direction " + std::to_string(delta));
      Random random(seed);
      std::vector<NoiseAt> found;
      for (int i = 0; i < 1000; ++i) {
        // Most surfaces are seen about head on.
        const double cosine = i % 4 == 0 ? random.uniform(0.25, 0.6) : random.uniform(0.8, 1);
        const double across = 0.001 * cosine + delta * std::sqrt(1 - cosine * cosine);
        found.push_back({random.uniform(1, 2), across / cosine * (1 + 0.1 * random.normal()), cosine});
      }
      const double noise = fit_noise_law(found).at(1.5);
      EXPECT_GT(noise, std::max(0.0008, 0.8 * delta));
      EXPECT_LT(noise, delta == 0 ? 0.0012 : 0.0015 + delta);
    }
}

TEST(NoiseOfScans, GrowsWithTheRange) {
  for (const double per_range : {0.001, 0.003}) {
    simulation::ScanOptions options;
    options.points = 50'000;
    options.noise_per_range = per_range;
    options.viewpoints = {{1.5, 1.2, 0.9}};
    std::vector<model::SensorPoint> points;
    double nearest = 1e9, farthest = 0;
    for (const auto& p : simulation::scan(simulation::make_scene("room:1").mesh, options)) {
      points.push_back(p.point);
      nearest = std::min(nearest, p.point.range), farthest = std::max(farthest, p.point.range);
    }
    ASSERT_GT(farthest, 2 * nearest);
    const Estimate found = estimate_of(points);
    for (const double range : {found.near_range, found.far_range})
      EXPECT_NEAR(found.noise.at(range), per_range * range, 0.3 * per_range * range) << "range " << range;
  }
}

/// A slanting plane seen by a depth camera at the origin, its depths rounded to steps that grow with their
/// square.
std::vector<model::SensorPoint> rounded_depths(double slope, double steps) {
  std::vector<model::SensorPoint> points;
  for (int v = -120; v < 120; ++v) {
    for (int u = -160; u < 160; ++u) {
      const Eigen::Vector3d ray(u / 260.0, v / 260.0, 1);
      const double depth = 1 / ((1 - slope * ray.y()) / 3);
      const double rounded = 1 / (std::round(1 / (steps * depth)) * steps);
      const Eigen::Vector3d p = rounded * ray;
      points.push_back({p, p.normalized(), p.norm()});
    }
  }
  return points;
}

TEST(NoiseOfScans, IsNotNothingWhereDepthsAreRounded) {
  constexpr double kSteps = 0.00275;  // of the inverse depth
  for (const double slope : {0.0, 0.3, 0.8}) {
    SCOPED_TRACE(slope);
    const Estimate found = estimate_of(rounded_depths(slope, kSteps));
    if (slope == 0) continue;  // one single step: nothing tells how large it is
    const double step = kSteps * found.far_range * found.far_range;
    EXPECT_GT(found.noise.at(found.far_range), 0.15 * step);
    EXPECT_LT(found.noise.at(found.far_range), step);
  }
}

/// The faces of a cube of 20, exact, along the axes or turned. Along them every face has one depth, which is
/// no rounding.
TEST(NoiseOfScans, ExactOnesHaveNoneInAnyPosition) {
  for (const double turn : {0.0, 0.4})
    for (const std::uint64_t seed : {1, 2, 3}) {
      SCOPED_TRACE("turned by " + std::to_string(turn) + ", seed " + std::to_string(seed));
      const Eigen::AngleAxisd turned(turn, Eigen::Vector3d(1, 2, 3).normalized());
      Random random(seed);
      std::vector<model::SensorPoint> points;
      for (int i = 0; i < 10'000; ++i) {
        Eigen::Vector3d p(random.uniform(0, 20), random.uniform(0, 20), random.uniform(0, 20)),
            inwards = Eigen::Vector3d::Zero();
        const auto axis = static_cast<Eigen::Index>(random.below(3));
        const bool far = random.below(2) == 1;
        p[axis] = far ? 20 : 0, inwards[axis] = far ? -1 : 1;
        points.push_back({turned * p, turned * inwards});
      }
      const Estimate found = estimate_of(points);
      EXPECT_EQ(found.noise.fixed, 0);
      EXPECT_FALSE(found.noise.varies());
    }
}

}  // namespace
}  // namespace limpet::survey
