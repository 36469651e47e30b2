// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/following/thesis/gap_following_internal.hpp>
#include <limpet/following/thesis/gap_internal.hpp>

#include "initial_model.hpp"

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;

TEST(GapPoint, IsWhereTheGapReachesThePerimeter) {
  const auto model = initial_model({{rectangle(0.5, 0, 1, 1)}});
  const model::View::Nearest closest = *model.view().nearest({0.7, 0.5, 0.1}, 1);
  EXPECT_TRUE(gap_point(model.view(), {0.2, 0.5, 0.05}, closest).isApprox(Vector3d(0.5, 0.5, 0), 1e-3));
}

TEST(GapPoint, IsTheClosestPointWhereTheWayToItMeetsNoPerimeter) {
  const auto model = initial_model({{rectangle(0, 0, 1, 1)}});
  const model::View::Nearest closest = *model.view().nearest({0.7, 0.5, 0.1}, 1);
  EXPECT_TRUE(gap_point(model.view(), {0.2, 0.5, 0.3}, closest).isApprox(closest.at));
}

TEST(TargetPoints, BeginAtTheGapPointHalfAResolutionApart) {
  const auto targets = target_points({0, 0, 0}, {0.11, 0, 0}, 0.025);
  ASSERT_EQ(targets.size(), 5u);
  for (std::size_t i = 0; i < targets.size(); ++i)
    EXPECT_TRUE(targets[i].isApprox(Vector3d(0.025 * static_cast<double>(i), 0, 0)));
  EXPECT_EQ(target_points({1, 2, 3}, {1, 2, 3}, 0.025).size(), 1u);
}

TEST(SensingAxis, EndsAtItsRange) {
  const kinematics::Posture::Sensor sensor{{0, 0, 0}, {1, 0, 0}, 0.2};
  EXPECT_TRUE(nearest_on_axis(sensor, {0.1, 0.3, 0}).isApprox(Vector3d(0.1, 0, 0)));
  EXPECT_TRUE(nearest_on_axis(sensor, {0.5, 0.3, 0}).isApprox(Vector3d(0.2, 0, 0)));
  EXPECT_TRUE(nearest_on_axis(sensor, {-1, 0.3, 0}).isZero());
}

}  // namespace
}  // namespace limpet::following::internal
