// Copyright the limpet authors. GPL-3.0-or-later.
//
// Known cases; the laws are in predicates_laws_test.cpp.
#include <cmath>

#include <gtest/gtest.h>

#include <limpet/geometry/predicates.hpp>

namespace limpet::geometry {
namespace {

TEST(EdgesOverlap, OnlyWhenTheyPointTheSameWay) {
  EXPECT_TRUE(edges_overlap({0, 0}, {2, 4}, {1, 2}));
  EXPECT_FALSE(edges_overlap({0, 0}, {2, 4}, {-1, -2}));
  EXPECT_FALSE(edges_overlap({0, 0}, {2, 4}, {1, 3}));
  EXPECT_TRUE(edges_overlap({5, 5}, {5, 9}, {5, 6}));
  EXPECT_TRUE(edges_overlap({5, 5}, {9, 5}, {7, 5}));
  EXPECT_TRUE(edges_overlap({5, 5}, {5, 5}, {7, 5}));
  const double far = 0x1p40;
  EXPECT_TRUE(edges_overlap({0, 0}, {far, far}, {1, 1}));
  EXPECT_FALSE(edges_overlap({0, 0}, {far, far + 1}, {1, 1}));
}

TEST(RoundToGrid, TiesGoUp) {
  EXPECT_EQ(round_to_grid({0.5, -0.5}), (Point2{1, 0}));
  EXPECT_EQ(round_to_grid({1.49, -1.51}), (Point2{1, -2}));
  EXPECT_EQ(round_to_grid({7, -7}), (Point2{7, -7}));
}

TEST(RoundToGrid, JustBelowAHalfAndAbove2To52) {
  const double below = std::nextafter(0.5, 0);
  EXPECT_EQ(round_to_grid({below, -below}), (Point2{0, 0}));
  EXPECT_EQ(round_to_grid({0x1p52 + 1, -0x1p52 - 1}), (Point2{0x1p52 + 1, -0x1p52 - 1}));
}

}  // namespace
}  // namespace limpet::geometry
