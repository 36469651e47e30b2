// Copyright the limpet authors. GPL-3.0-or-later.
//
// One surface in two polygons whose planes cross, or lie close to each other (docs/rules.md, `twins`).
#include <gtest/gtest.h>

#include "judged_scan.hpp"

namespace limpet::model {
namespace {

using namespace testing;

Parameters parameters_with(const char* rules, double noise) {
  Parameters parameters = of_resolution(0.1);
  parameters.noise = noise;
  parameters.tolerance = 0.03;
  parameters.rules = Rules::parse(rules);
  return parameters;
}

/// A plate, moved and turned about y so that its height is `rise` · (x − `about`) + `offset`.
Points tilted_plate(Random& random, int count, double x0, double x1, double rise, double about,
                    double offset) {
  Points points = plate(random, count, x0, 0, x1, 1, 0.005);
  for (auto& p : points) p.position.z() += rise * (p.position.x() - about) + offset;
  return points;
}

std::size_t polygons_of(const Points& points, const char* rules, double noise = 0.005) {
  const ModelRecord record = modelled(parameters_with(rules, noise), points).record();
  EXPECT_EQ(broken_laws(record), "") << rules;
  return record.polygon_segments.size();
}

/// What is felt first, in a plane of its own, and then the surface that it is a part of.
struct TwoPlanes {
  const char* name;
  double rise, offset;
  double given_noise;  ///< instead of 0.005
};
class TwinsOfOneSurface : public ::testing::TestWithParam<TwoPlanes> {};

TEST_P(TwinsOfOneSurface, BecomeOne) {
  const auto& [name, rise, offset, noise] = GetParam();
  Random random(7);
  Points points = tilted_plate(random, 700, 0.7, 1.3, rise, 1, offset);
  for (const auto& p : tilted_plate(random, 4000, 0, 2, 0, 0, 0)) points.push_back(p);
  EXPECT_EQ(polygons_of(points, "limpet", noise), 1u);
  EXPECT_GT(polygons_of(points, "-twins", noise), 1u);
}

INSTANTIATE_TEST_SUITE_P(Twins, TwinsOfOneSurface,
                         ::testing::Values(TwoPlanes{"Crossing", 0.15, 0, 0.005},
                                           TwoPlanes{"Parallel", 0, 0.012, 0.0015}),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// Beside each other, two surfaces within the tolerance of each other's plane stay two.
TEST(Twins, AStepIsNone) {
  Random random(8);
  Points points = tilted_plate(random, 2500, 0, 1, 0, 0, 0);
  for (const auto& p : tilted_plate(random, 2000, 1, 2, 0, 0, 0.028)) points.push_back(p);
  EXPECT_EQ(polygons_of(points, "limpet"), 2u);
}

}  // namespace
}  // namespace limpet::model
