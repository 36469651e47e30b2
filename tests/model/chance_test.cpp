// Copyright the limpet authors. GPL-3.0-or-later.
//
// What finishing adds without a reading: only what chance leaves empty, near where the surface was felt.
#include <gtest/gtest.h>

#include <cmath>
#include <limpet/model/chance_internal.hpp>

#include "judged_scan.hpp"
#include "streams.hpp"

namespace limpet::model {
namespace {

using namespace testing;

TEST(Chance, LeavesAHundredthOfAnEmptyDiscAboveItsBound) {
  for (double m = 10; m < 1e9; m *= 7) {
    const double a = internal::most_expected_in_empty_disc(static_cast<std::int64_t>(m));
    EXPECT_NEAR(2 * std::floor(m) * (1 + a) * std::exp(-a), 0.01, 1e-9) << m;
  }
}

/// Readings at random, `density` to λ² = 1, of a plate with n × n square holes that are 6 λ apart.
Points holed_plate(std::uint64_t seed, int n, double hole, double density) {
  Random random(seed);
  const double pitch = hole + 6, size = n * pitch;
  Points points = plate(random, static_cast<int>(density * size * size), 0.0, 0.0, size, size, 0.01);
  std::erase_if(points, [&](const SensorPoint& p) {
    const double x = std::fmod(p.position.x(), pitch) - 3, y = std::fmod(p.position.y(), pitch) - 3;
    return x > 0 && x < hole && y > 0 && y < hole;
  });
  return points;
}

std::int64_t holes_left(std::uint64_t seed, double hole, double density) {
  Parameters parameters = of_resolution(1);
  parameters.noise = 0.01;
  const Model model = modelled(parameters, holed_plate(seed, 10, hole, density));
  EXPECT_EQ(model.counts().polygons, 1) << "seed " << seed;
  EXPECT_EQ(broken_laws(model.record()), "") << "seed " << seed;
  return model.counts().holes;
}

TEST(Chance, TrueHolesStay) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    EXPECT_GE(holes_left(seed, 2.7, 5), 98) << "seed " << seed;
    EXPECT_EQ(holes_left(seed, 4, 5), 100) << "seed " << seed;
    EXPECT_GE(holes_left(seed, 2, 10), 80) << "seed " << seed;
  }
}

TEST(Chance, GapsBetweenReadingsAreNoHoles) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed)
    for (const double density : {3.0, 5.0, 10.0})
      EXPECT_EQ(holes_left(seed, 0, density), 0) << "seed " << seed;
}

/// Facets of a curved surface are never stretched far from it, whatever their planes do. (Of some twenty
/// readings, one may be so tilted that what chance allows in its plane is more than λ off the sphere.)
TEST(Chance, ASphereStaysASphere) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const auto scene = simulation::make_scene("sphere:64");
    simulation::ScanOptions options;
    options.points = 10'000, options.noise = 0.001, options.seed = seed,
    options.viewpoints = scene.viewpoints;
    Parameters parameters = of_resolution(0.04);
    parameters.noise = 0.001, parameters.tolerance = 0.008;
    Points points;
    for (const auto& p : simulation::scan(scene.mesh, options)) points.push_back(p.point);
    const ModelRecord record = modelled(parameters, points).record();
    double farthest = 0;
    for (const auto& polygon : record.polygon_segments)
      for (const auto& vertex : world_perimeter(polygon, record.grid_step))
        farthest = std::max(farthest, std::abs(vertex.norm() - 0.5));
    EXPECT_LT(farthest, 2 * parameters.resolution) << "seed " << seed;
    EXPECT_EQ(broken_laws(record), "") << "seed " << seed;
  }
}

}  // namespace
}  // namespace limpet::model
