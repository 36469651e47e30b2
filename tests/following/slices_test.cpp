// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/following/thesis/slices_internal.hpp>

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;
using Edge = model::View::Edge;

constexpr double kResolution = 0.1;  // slices are 0.05 wide

Edge edge(const Vector3d& from, const Vector3d& to, std::uint64_t segment = 1) {
  Edge e;
  e.id = {7}, e.segment = {segment}, e.from = from, e.to = to;
  return e;
}

/// Slices of an edge from the origin along x, the first one used.
Slices with_first_used() {
  Slices slices(kResolution);
  const Edge e = edge({0, 0, 0}, {1, 0, 0});
  slices.begin(e);
  slices.choose(e, {0, 0, 0});
  slices.use();
  return slices;
}

TEST(Slices, CoverTheEdgeOnceInOneBlock) {
  Slices slices(kResolution);
  const Edge e = edge({0, 0, 0}, {0.49, 0, 0});
  EXPECT_FALSE(slices.begin(e));
  int count = 0;
  double low = 1, high = 0;
  while (slices.choose(e, {0.26, 0.1, 0})) {
    const double x = slices.current_point(e).x();
    EXPECT_TRUE(count == 0 || x < low || x > high);  // beside the used ones, on one of the sides
    low = std::min(low, x), high = std::max(high, x);
    ++count;
    slices.use();
  }
  EXPECT_EQ(count, 10);
  EXPECT_TRUE(slices.has_used());
}

TEST(Slices, BeginWithTheOneNearestToTheControlPoint) {
  Slices slices(kResolution);
  const Edge e = edge({0, 0, 0}, {1, 0, 0});
  slices.begin(e);
  ASSERT_TRUE(slices.choose(e, {0.62, 5, 5}));
  EXPECT_TRUE(slices.contains({0.601, 9, 9}));
  EXPECT_FALSE(slices.contains({0.66, 0, 0}));
  EXPECT_TRUE(slices.current_point(e).isApprox(Vector3d(0.625, 0, 0)));
  EXPECT_TRUE(slices.to_centre({0.725, 1, 2}).isApprox(Vector3d(-0.1, 0, 0)));
  EXPECT_TRUE(slices.from_line({0.3, 1, 2}).isApprox(Vector3d(0, 1, 2)));
}

TEST(Slices, AreKeptForASimilarEdge) {
  EXPECT_TRUE(with_first_used().begin(edge({0, 0.05, 0}, {0.5, -0.05, 0})));
}

TEST(Slices, AreNotKeptWhereAVertexIsTooFarFromTheLine) {
  EXPECT_FALSE(with_first_used().begin(edge({0, 0, 0}, {0.5, 0.11, 0})));
}

TEST(Slices, AreNotKeptWhereTheAngleIsTooGreat) {
  EXPECT_FALSE(with_first_used().begin(edge({0, 0, 0}, {0.05, 0.06, 0})));
  EXPECT_FALSE(with_first_used().begin(edge({0.5, 0, 0}, {0, 0, 0})));
}

TEST(Slices, AreNotKeptWhereNoUsedSlicePassesThroughTheEdge) {
  EXPECT_FALSE(with_first_used().begin(edge({0.5, 0, 0}, {0.9, 0, 0})));
}

TEST(Slices, AreNotKeptForAnotherSegment) {
  EXPECT_FALSE(with_first_used().begin(edge({0, 0, 0}, {1, 0, 0}, 2)));
}

}  // namespace
}  // namespace limpet::following::internal
