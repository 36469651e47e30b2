// Copyright the limpet authors. GPL-3.0-or-later.
//
// Readings all over a cube, from all sides: nothing is there but what chance makes of them, and all of it
// meets everything else. Corners of four planes are formed beside their lines, and lose their edges again.
#include <gtest/gtest.h>

#include "judged_scan.hpp"

namespace limpet::model {
namespace {

using namespace testing;

Points noise_in_a_cube(std::uint64_t seed, double side, int count) {
  Random random(seed);
  Points points;
  for (int i = 0; i < count; ++i) {
    SensorPoint p;
    for (int k = 0; k < 3; ++k) p.position[k] = random.uniform(0, side);
    for (int k = 0; k < 3; ++k) p.axis[k] = random.normal();
    points.push_back(p);
  }
  return points;
}

TEST(NoiseInACube, KeepsAllLaws) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Parameters parameters = of_resolution(0.1);
    parameters.noise = 0.01;
    const ModelRecord record = modelled(parameters, noise_in_a_cube(seed, 0.67, 6'000)).record();
    EXPECT_EQ(broken_laws(record), "");
    EXPECT_EQ(points_in_segments(record) + record.expired, record.points);
  }
}

}  // namespace
}  // namespace limpet::model
