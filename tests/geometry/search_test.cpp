// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/geometry/search.hpp>

#include "perimeters.hpp"

namespace limpet::geometry {
namespace {

TEST(NearestFraction, StaysOnTheSegment) {
  EXPECT_EQ(nearest_fraction({0, 0}, {10, 0}, {-5, 3}), 0);
  EXPECT_EQ(nearest_fraction({0, 0}, {10, 0}, {15, 3}), 1);
  EXPECT_EQ(nearest_fraction({0, 0}, {10, 0}, {4, 7}), 0.4);
  EXPECT_EQ(nearest_fraction({3, 3}, {3, 3}, {4, 7}), 0);
}

TEST(NearestPerimeterPoint, AgreesWithAllEdges) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    EdgeIds ids;
    const Polygon p = random_polygon(random, ids, random.scale(1, 1000), 1e6);
    for (int k = 0; k < 20; ++k) {
      const double within = random.scale(1, 1000);
      const Point2 q = telling_point(random, p, within);
      const auto found = nearest_perimeter_point(p, q, within);
      const double distance = distance_to(p, q);
      if (std::abs(distance - within) < 1e-6) continue;
      ASSERT_EQ(found.has_value(), distance < within);
      if (found) {
        ASSERT_NEAR(std::sqrt(found->squared_distance), distance, 1e-6);
      }
    }
  }
}

TEST(NearestPerimeterPoint, TiesGoToTheOldestEdge) {
  EdgeIds ids;
  const Polygon p = make({rectangle(0, 0, 10, 10)}, ids);
  const auto found = nearest_perimeter_point(p, {5, 5}, 100);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(p.node(found->edge).edge, EdgeId{1});
}

TEST(Sights, MeetsNoEdgeButAtItsOwnVertices) {
  EdgeIds ids;
  const Polygon notch =
      make({cycle_of({{0, 0}, {90, 0}, {90, 90}, {60, 90}, {60, 30}, {30, 30}, {30, 90}, {0, 90}})}, ids);
  const Point2 above{45, 120};
  EXPECT_TRUE(sights(notch, {above}, {{60, 30}, Slot{4}}));
  EXPECT_FALSE(sights(notch, {above}, {{90, 0}, Slot{1}}));
  EXPECT_FALSE(sights(notch, {above}, {{60, 30}}));                       // not told that it is a vertex
  EXPECT_FALSE(sights(notch, {{60, 90}, Slot{3}}, {{60, 30}, Slot{4}}));  // along an edge
  EXPECT_TRUE(sights(notch, {{60, 90}, Slot{3}}, {{30, 90}, Slot{6}}));
  EXPECT_TRUE(sights(notch, {above}, {{45, 30}}, {Slot{4}}));  // a foot on an edge left aside
}

}  // namespace
}  // namespace limpet::geometry
