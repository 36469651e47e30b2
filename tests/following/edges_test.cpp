// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/following/thesis/edges_internal.hpp>

#include "initial_model.hpp"

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;

const Parameters kParameters = usual_parameters(0.05);  // δ 0.1, ρ 0.2

Vector3d direction(double distance) {
  return towards_and_along({0, 0, 0}, {1, 0, 0}, {0.5, distance, 0}, kParameters);
}

TEST(FollowEdge, IsFollowedParallelWithinTheFollowDistance) {
  EXPECT_TRUE(direction(0.05).isApprox(Vector3d(1, 0, 0)));
  EXPECT_TRUE(direction(0.1).isApprox(Vector3d(1, 0, 0)));
  EXPECT_TRUE(direction(0).isApprox(Vector3d(1, 0, 0)));
}

TEST(FollowEdge, AttractsStraightFromTheStrayLimitOn) {
  EXPECT_TRUE(direction(0.2).isApprox(Vector3d(0, -1, 0)));
  EXPECT_TRUE(direction(5).isApprox(Vector3d(0, -1, 0)));
}

TEST(FollowEdge, AttractsInProportionBetween) {
  EXPECT_TRUE(direction(0.15).isApprox(Vector3d(0.5, -0.5, 0)));
  EXPECT_TRUE(direction(0.125).isApprox(Vector3d(0.75, -0.25, 0)));
}

TEST(FollowEdge, NearestPointIsAnEndBeyondIt) {
  EXPECT_TRUE(nearest_on({0, 0, 0}, {1, 0, 0}, {2, 3, 4}).isApprox(Vector3d(1, 0, 0)));
  EXPECT_EQ(nearest_on({1, 1, 1}, {1, 1, 1}, {2, 3, 4}), Vector3d(1, 1, 1));
}

TEST(TowardsOutside, LeadsRoundTheClosestEdge) {
  const auto model = initial_model({{rectangle(0, 0, 1, 1)}});
  const auto id = segments_of(model).front();
  // Under the square, near the edge at y = 0: outwards and up.
  const auto below = towards_outside(model.view(), id, {0.5, 0.1, -0.1});
  ASSERT_TRUE(below);
  EXPECT_LT(below->y(), 0);
  const auto beside = towards_outside(model.view(), id, {0.5, -0.1, -0.1});
  ASSERT_TRUE(beside);
  EXPECT_GT(beside->z(), 0);
  EXPECT_FALSE(towards_outside(model.view(), id, {0.5, 0.1, 0.1}));
}

}  // namespace
}  // namespace limpet::following::internal
