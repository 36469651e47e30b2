// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/following/links/unmodelled_readings.hpp>

#include "initial_model.hpp"

namespace limpet::following {
namespace {

using Eigen::Vector3d;

std::vector<model::SensorPoint> readings_at(const std::vector<Vector3d>& places) {
  std::vector<model::SensorPoint> readings;
  for (const Vector3d& place : places) readings.push_back({place, -Vector3d::UnitZ(), 0.1});
  return readings;
}

TEST(UnmodelledReadings, AreThoseThatNoPolygonIsNear) {
  const model::Model model = initial_model({{rectangle(0, 0, 1, 1)}});
  UnmodelledReadings readings(0.01);
  readings.look(model.view(), readings_at({{0.5, 0.5, 0.005}, {0.5, 0.5, 0.02}, {1.5, 0.5, 0}}));
  ASSERT_EQ(readings.positions().size(), 2u);
  EXPECT_EQ(readings.positions()[0], Vector3d(0.5, 0.5, 0.02));
  EXPECT_EQ(readings.positions()[1], Vector3d(1.5, 0.5, 0));
}

TEST(UnmodelledReadings, GoOnceThereIsAPolygon) {
  const model::Model nothing(model::Parameters{}), model = initial_model({{rectangle(0, 0, 1, 1)}});
  UnmodelledReadings readings(0.01);
  readings.look(nothing.view(), readings_at({{0.5, 0.5, 0}, {0.5, 0.5, 1}}));
  EXPECT_EQ(readings.positions().size(), 2u);
  readings.look(model.view(), {});
  EXPECT_EQ(readings.positions(), std::vector<Vector3d>{Vector3d(0.5, 0.5, 1)});
}

TEST(UnmodelledReadings, AreRememberedForEightySets) {
  const model::Model nothing(model::Parameters{});
  UnmodelledReadings readings(0.01);
  for (int set = 0; set < 200; ++set) {
    readings.look(nothing.view(), readings_at({Vector3d(set, 0, 0)}));
    ASSERT_EQ(readings.positions().size(), static_cast<std::size_t>(std::min(set + 1, 80)));
    EXPECT_EQ(readings.positions().front(), Vector3d(std::max(0, set - 79), 0, 0));
    EXPECT_EQ(readings.positions().back(), Vector3d(set, 0, 0));
  }
}

}  // namespace
}  // namespace limpet::following
