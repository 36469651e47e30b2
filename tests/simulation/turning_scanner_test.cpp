// Copyright the limpet authors. GPL-3.0-or-later.
//
// A scanner that sends its rays at equal angles, column by column.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limpet/simulation/shapes.hpp>
#include <limpet/simulation/turning_scanner.hpp>
#include <vector>

namespace limpet::simulation {
namespace {

using Eigen::Vector3d;

const Vector3d kStand(2.1, 1.7, 1.5);

std::vector<Vector3d> directions_of(const ScanPattern& pattern, double pitch) {
  std::vector<Vector3d> directions;
  pattern.sweep(pitch, [&](const RayCaster::Hit& hit, const Vector3d& direction) {
    EXPECT_NEAR((hit.position - kStand - hit.range * direction).norm(), 0, 1e-9);
    directions.push_back(direction);
  });
  return directions;
}

TEST(TurningScanner, EqualAnglesFromTheTripodToTheZenith) {
  const TurningScanner scanner(make_shape("room:1:2:2"), {kStand});
  for (const double pitch : {0.02, 0.1}) {
    const auto directions = directions_of(scanner, pitch);
    // A closed room: every ray meets it.
    const double rows = std::ceil(2.617993877991494 / pitch), columns = std::ceil(6.283185307179586 / pitch);
    ASSERT_EQ(static_cast<double>(directions.size()), rows * columns);
    for (std::size_t i = 0; i < directions.size(); ++i) {
      EXPECT_NEAR(directions[i].norm(), 1, 1e-12);
      EXPECT_GE(directions[i].z(), -0.8660254037844387) << "the tripod is below";
      if (i % static_cast<std::size_t>(rows) == 0) continue;
      const double angle = std::acos(std::min(1.0, directions[i].dot(directions[i - 1])));
      EXPECT_NEAR(angle, pitch, pitch * pitch * pitch / 10);
    }
    const auto row = static_cast<std::size_t>(rows);
    const Vector3d first(directions[0].x(), directions[0].y(), 0),
        next(directions[row].x(), directions[row].y(), 0);
    EXPECT_NEAR(std::acos(first.normalized().dot(next.normalized())), pitch, pitch * pitch * pitch / 10);
  }
}

TEST(TurningScanner, AsManyPointsAsAskedForFromEachStand) {
  const Mesh room = make_shape("room:1:3:2");
  for (const std::int64_t points : {5'000, 50'000})
    for (const std::vector<Vector3d>& stands :
         {std::vector<Vector3d>{kStand}, std::vector<Vector3d>{kStand, {4.1, 1.9, 1.6}}}) {
      const TurningScanner scanner(room, stands);
      std::int64_t hits = 0;
      scanner.sweep(scanner.pitch_for(points), [&](const RayCaster::Hit&, const Vector3d&) { ++hits; });
      EXPECT_NEAR(static_cast<double>(hits) / static_cast<double>(points), 1, 0.05);
    }
}

}  // namespace
}  // namespace limpet::simulation
