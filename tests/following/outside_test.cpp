// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/following/thesis/outside_internal.hpp>

#include "initial_model.hpp"

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;

/// A U: two arms with a bay 0.1 wide between them, open at the top.
model::Model bay() {
  return initial_model({{{{0, 0, 0},
                          {1, 0, 0},
                          {1, 1, 0},
                          {0.55, 1, 0},
                          {0.55, 0.5, 0},
                          {0.45, 0.5, 0},
                          {0.45, 1, 0},
                          {0, 1, 0}}}});
}

Outside outside(const model::Model& model, const Vector3d& at_edge) {
  const auto edge = edge_at(model, segments_of(model).front(), at_edge);
  return {model.view(), edge, (edge.to - edge.from).normalized()};
}

TEST(Outside, OwnPolygonBeyondAGapLiesOutside) {
  const auto model = bay();
  const Vector3d left(0.45, 0.75, 0);
  EXPECT_TRUE(outside(model, left).is_near(left, 0.11));
  EXPECT_FALSE(outside(model, left).is_near(left, 0.09));
}

TEST(Outside, OwnPolygonBehindAnEdgeDoesNot) {
  const auto model = bay();
  for (const Vector3d& at : {Vector3d(0, 0.5, 0), Vector3d(0.5, 0, 0), Vector3d(0.2, 1, 0)})
    EXPECT_FALSE(outside(model, at).is_near(at, 0.4)) << at.transpose();
}

TEST(Outside, OtherSegmentsLieOutsideWhereverTheyAre) {
  const auto model = initial_model({{rectangle(0, 0, 1, 1)}, {rectangle(0.2, 0.05, 0.4, 0.4, 0.1)}});
  const Vector3d below(0.3, 0, 0);
  EXPECT_TRUE(outside(model, below).is_near(below, 0.12));
  EXPECT_FALSE(outside(model, below).is_near(below, 0.1));
}

TEST(Outside, TellsWhereTheClosestPointIs) {
  const auto model = bay();
  const auto id = segments_of(model).front();
  const Outside of_left = outside(model, {0.45, 0.75, 0});
  const auto found = [&](const Vector3d& p) { return *model.view().nearest(p, 1); };
  EXPECT_TRUE(of_left.contains(found({0.56, 0.75, 0.1})));   // the other arm
  EXPECT_FALSE(of_left.contains(found({0.4, 0.75, 0.1})));   // its own inside
  EXPECT_FALSE(of_left.contains(found({0.46, 0.75, 0.1})));  // the edge itself
  EXPECT_FALSE(of_left.contains(found({0.56, 0.3, 0.1})));   // beside the lines through its vertices
  auto other = found({0.56, 0.3, 0.1});
  other.segment = {id.value + 1};
  EXPECT_TRUE(of_left.contains(other));
}

}  // namespace
}  // namespace limpet::following::internal
