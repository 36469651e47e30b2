// Copyright the limpet authors. GPL-3.0-or-later.
//
// Where a polygon was felt, and where readings have passed through it, when it is cut in two and joined
// again.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limpet/model/felt_internal.hpp>
#include <limpet/model/passages_internal.hpp>
#include <limpet/survey/random.hpp>

namespace limpet::model::internal {
namespace {

using Eigen::Vector3d;

Setting setting_of(double per_range) {
  Parameters parameters;
  parameters.resolution = 0.05;
  parameters.resolution_per_range = per_range;
  if (per_range > 0) parameters.sensors = {{0, 0, 1}};
  return Setting(parameters);
}

/// A square part, its lower left corner at x, y.
Felt felt_at(const Setting& setting, double x, double y, double side, std::int64_t points) {
  const geometry::Chart chart({x, y, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, setting.step);
  const double s = std::round(side / setting.step);
  const std::vector<geometry::NewVertex> square{{{0, 0}}, {{s, 0}}, {{s, s}}, {{0, s}}};
  geometry::EdgeIds ids;
  return {setting, chart, *geometry::Polygon::from_cycles(std::array{square}, ids), points};
}

TEST(Felt, PartsThatBothHaveCountOnceHoweverOftenItIsCutAndJoined) {
  const Setting setting = setting_of(0);
  Felt felt = felt_at(setting, 0, 0, 1, 400);
  felt.add(felt_at(setting, 2, 0, 1, 800));
  felt.add(Vector3d(0.5, 1.1, 0));
  const double density = felt.density();
  for (int i = 0; i < 40; ++i) {
    Felt piece = felt;
    piece.add(Vector3d(1.1, 0.5, 0));
    felt.add(std::move(piece));
  }
  EXPECT_EQ(felt.parts().size(), 2u);
  EXPECT_EQ(felt.density(), density);
  EXPECT_NEAR(felt.distance({0.5, 1.2, 0}, 5), 0.1, 1e-5);
  EXPECT_NEAR(felt.distance({1.2, 0.5, 0}, 5), 0.1, 1e-5);
  EXPECT_NEAR(felt.distance({1.5, 1.5, 0}, 0.25), 0.25, 1e-5);
  felt.add(felt_at(setting, 4, 0, 1, 800));
  EXPECT_EQ(felt.parts().size(), 3u);
}

TEST(Felt, WhereLambdaGrowsReadingsAreAsManyToItsSquare) {
  const Setting setting = setting_of(0.1);
  const Felt felt = felt_at(setting, 0, 0, 4, 100'000);
  // The densities over the area add up to the readings; the perimeter's rim counts as felt, too.
  double sum = 0;
  const int across = 64;
  for (int i = 0; i < across * across; ++i) {
    const int column = i % across, row = i / across;
    const Vector3d p(4 * (column + 0.5) / across, 4 * (row + 0.5) / across, 0);
    sum += felt.density(setting.least.lambda2 / setting.scale_at(p).lambda2) * 16 / (across * across);
  }
  EXPECT_NEAR(sum / 100'000, 1, 0.02);
  const auto at = [&](double x) {
    return felt.density(setting.least.lambda2 / setting.scale_at({x, 0, 0}).lambda2);
  };
  EXPECT_GT(at(0), 5 * at(4));
}

TEST(Passages, AreDividedWithThePolygon) {
  survey::Random random(3);
  Passages all;
  std::int64_t passed = 0;
  for (int i = 0; i < 500; ++i) {
    all.add({random.uniform(0, 4), random.uniform(0, 4), 0}, 1);
    if (i % 3 == 0) all.note_through(5), ++passed;
  }
  const auto count = [](const Passages& p) {
    std::int64_t sum = 0;
    for (const auto& place : p.places()) sum += place.count;
    return sum;
  };
  const std::int64_t places = count(all);
  Passages rest = all;
  const Passages piece = rest.split([](const Vector3d& p) { return p.x() < 1; }, 0.3);
  for (const auto& place : piece.places()) EXPECT_LT(place.at.x(), 1);
  for (const auto& place : rest.places()) EXPECT_GE(place.at.x(), 1);
  EXPECT_EQ(count(piece) + count(rest), places);
  EXPECT_EQ(piece.rays() + rest.rays(), passed);
  EXPECT_EQ(piece.through() + rest.through(), 5 * passed);
  EXPECT_NEAR(static_cast<double>(piece.rays()), 0.3 * static_cast<double>(passed), 1);
  EXPECT_GE(piece.through(), piece.rays());
  rest.add(piece, 1);
  EXPECT_EQ(count(rest), places);
}

/// A surface begins as several polygons, and a ray that passes near them is noted with each.
TEST(Passages, OfOneRayNotedWithSeveralPolygonsCountOnce) {
  Passages whole, part;
  for (Passages* passages : {&whole, &part}) passages->add(Vector3d(1, 1, 0), 0.5);
  part.add(Vector3d(3, 1, 0), 0.5), part.add(Vector3d(3, 1.1, 0), 0.5);
  whole.add(part, 0.5);
  whole.add(part, 0.5);
  ASSERT_EQ(whole.places().size(), 2u);
  EXPECT_EQ(whole.places()[0].count, 1);
  EXPECT_EQ(whole.places()[1].count, 2);
}

}  // namespace
}  // namespace limpet::model::internal
