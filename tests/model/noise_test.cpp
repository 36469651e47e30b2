// Copyright the limpet authors. GPL-3.0-or-later.
//
// Noise and tolerance are two things: noise says what is a surface at all and where it goes on, the tolerance
// how far from its plane it may lie.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include <limpet/model/fit_internal.hpp>
#include <limpet/model/moments_internal.hpp>

#include "streams.hpp"

namespace limpet::model {
namespace {

using namespace testing;

/// The same but for the numbers that say how the noise came about.
std::string bytes_without_noise(ModelRecord record) {
  record.parameters.noise = record.parameters.noise_per_range = record.parameters.noise_per_range2 = 0;
  return bytes(record);
}

Points with_range(Points points, double range) {
  for (auto& p : points) p.range = range;
  return points;
}

TEST(Noise, FromOneRangeItIsOneNumber) {
  constexpr double kRange = 4;  // powers of two, so that the sums are exact
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Random random(seed);
    const Points points = plate(random, 3000, 0, 0, 1, 1, 0.01);
    Parameters one = of_resolution(0.1);
    one.noise = 0.0078125;
    Parameters linear = of_resolution(0.1), square = of_resolution(0.1);
    linear.noise_per_range = one.noise / kRange;
    square.noise_per_range2 = one.noise / kRange / kRange;
    const auto truth = modelled(one, points).record();
    EXPECT_FALSE(truth.polygon_segments.empty());
    const auto far = with_range(points, kRange);
    auto from_far = modelled(linear, far).record();
    for (auto* record : {&from_far}) EXPECT_EQ(broken_laws(*record), "");
    EXPECT_EQ(from_far.polygon_segments.size(), truth.polygon_segments.size());
    const auto squared = modelled(square, far).record();
    EXPECT_EQ(bytes_without_noise(squared), bytes_without_noise(from_far)) << "seed " << seed;
  }
}

TEST(Noise, FarReadingsMakeAPlaneWhereNearOnesMakeNone) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Points points = plate(random, 2000, 0, 0, 1, 1, 0.01);
    Parameters parameters = of_resolution(0.1);
    parameters.noise_per_range = 0.0025;
    const auto far = modelled(parameters, with_range(points, 4)).record();
    const auto near = modelled(parameters, with_range(points, 0.25)).record();
    ASSERT_EQ(far.polygon_segments.size(), 1u);
    EXPECT_GT(far.polygon_segments[0].moments.count, 1950);
    EXPECT_NE(near.polygon_segments.size(), 1u);
  }
}

/// A plate that bends by `height` over one metre, like an arch.
Points arch(Random& random, int count, double height, double noise) {
  Points points = plate(random, count, 0, 0, 1, 1, noise);
  for (auto& p : points) p.position.z() -= 4 * height * (p.position.x() - 0.5) * (p.position.x() - 0.5);
  return points;
}

TEST(Tolerance, KeepsABentSurfaceOnePolygon) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Points points = arch(random, 20'000, 0.012, 0.001);
    Parameters parameters = of_resolution(0.03);
    parameters.noise = 0.001;
    EXPECT_GT(modelled(parameters, points).record().polygon_segments.size(), 1u);
    parameters.tolerance = 0.012;
    const auto record = modelled(parameters, points).record();
    std::int64_t largest = 0;
    for (const auto& s : record.polygon_segments) largest = std::max(largest, s.moments.count);
    EXPECT_GT(largest, 19'800);
    EXPECT_EQ(broken_laws(record), "");
  }
}

/// Where readings come in any order, patches that straddle the step now and then bridge it before its sides
/// are known.
TEST(Tolerance, LeavesAStepThatTheNoiseTellsApart) {
  int kept = 0;
  for (const double step : {0.009, 0.011}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      Random random(seed);
      Points points = plate(random, 20'000, 0, 0, 1, 1, 0.001);
      for (auto& p : points)
        if (p.position.x() > 0.5) p.position.z() += step;
      Parameters parameters = of_resolution(0.03);
      parameters.noise = 0.001;
      parameters.tolerance = 0.012;
      const auto record = modelled(parameters, points).record();
      EXPECT_EQ(broken_laws(record), "") << "seed " << seed;
      int lower = 0, upper = 0;
      for (const auto& s : record.polygon_segments) {
        if (s.moments.count < 9000) continue;
        const double z = model::Moments(s.moments).centroid(record.grid_step).z();
        lower += std::abs(z) < 0.001, upper += std::abs(z - step) < 0.001;
      }
      kept += lower == 1 && upper == 1;
      if (lower != 1 || upper != 1) std::printf("step %g, seed %d: bridged\n", step, static_cast<int>(seed));
    }
  }
  EXPECT_GE(kept, 8);
}

TEST(Tolerance, BeyondItIsAnotherPolygon) {
  Random random(1);
  const Points points = arch(random, 20'000, 0.05, 0.001);
  Parameters parameters = of_resolution(0.03);
  parameters.noise = 0.001;
  parameters.tolerance = 0.005;
  const auto record = modelled(parameters, points).record();
  EXPECT_GT(record.polygon_segments.size(), 2u);
  for (const auto& s : record.polygon_segments) {
    const model::Moments moments(s.moments);
    const auto fit = fit_to(moments, record.grid_step, Eigen::Vector3d(0, 0, -1));
    EXPECT_LT(std::sqrt(fit.u3), parameters.tolerance);
  }
}

}  // namespace
}  // namespace limpet::model
