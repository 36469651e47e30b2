// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/geometry/extend.hpp>
#include <limpet/geometry/search.hpp>

#include "perimeters.hpp"

namespace limpet::geometry {
namespace {

TEST(Extend, ToAPointBesideAnEdgeTakesTheWholeEdgeWhenItIsNear) {
  EdgeIds ids;
  Polygon p = make({rectangle(0, 0, 100, 100)}, ids);
  ASSERT_EQ(extend_to_point(p, {50, -10}, 60, ids), Extension::extended);
  EXPECT_EQ(outline(p), outline({cycle_of({{0, 0}, {50, -10}, {100, 0}, {100, 100}, {0, 100}})}));
  EXPECT_EQ(p.take_removed(), std::vector<EdgeId>{EdgeId{1}});
  EXPECT_EQ(p.take_created().size(), 2u);
}

TEST(Extend, CutsALongEdgeWhereItLeavesTheDisc) {
  EdgeIds ids;
  Polygon p = make({rectangle(0, 0, 1000, 1000)}, ids);
  ASSERT_EQ(extend_to_point(p, {500, -30}, 50, ids), Extension::extended);
  // The disc leaves the edge 40 steps off the foot; the ends are two steps inside.
  EXPECT_EQ(
      outline(p),
      outline({cycle_of({{0, 0}, {462, 0}, {500, -30}, {538, 0}, {1000, 0}, {1000, 1000}, {0, 1000}})}));
}

TEST(Extend, FromAHoleInwards) {
  EdgeIds ids;
  Polygon p = make({rectangle(0, 0, 300, 300), reversed(rectangle(100, 100, 200, 200))}, ids);
  ASSERT_EQ(extend_to_point(p, {110, 150}, 60, ids), Extension::extended);
  ASSERT_EQ(p.hole_count(), 1u);
  EXPECT_EQ(p.locate({105, 150}), Polygon::Side::inside);
}

TEST(Extend, LeavesThePolygonAsItWasOtherwise) {
  EdgeIds ids;
  auto square = rectangle(0, 0, 100, 100);
  square[0].shared = true;
  const Polygon before = make({square}, ids);
  Polygon p = before;
  EXPECT_EQ(extend_to_point(p, {50, 50}, 60, ids), Extension::contained);
  EXPECT_EQ(extend_to_point(p, {100, 50}, 60, ids), Extension::contained);
  EXPECT_EQ(extend_to_point(p, {50, -10}, 60, ids), Extension::shared);
  EXPECT_EQ(extend_to_point(p, {50, 170}, 60, ids), Extension::refused);
  EXPECT_TRUE(same_boundary(p, before));
}

TEST(Extend, KeepsSharedEdges) {
  EdgeIds ids;
  auto square = rectangle(0, 0, 100, 100);
  square[0].shared = true;
  Polygon p = make({square}, ids);
  ASSERT_EQ(extend_to_point(p, {110, 10}, 80, ids), Extension::extended);
  const auto vertices = p.boundary()[0];
  EXPECT_TRUE(std::any_of(vertices.begin(), vertices.end(),
                          [](const NewVertex& v) { return v.edge == EdgeId{1} && v.shared; }));
}

/// All conditions of the thesis on one extension.
void expect_extended(const Polygon& before, Polygon& after, Point2 q, double gap) {
  ASSERT_EQ(judge_polygon(after), Verdict::valid);
  ASSERT_EQ(after.locate(q), Polygon::Side::boundary);
  std::vector<std::pair<double, double>> vertices;
  for (const auto& c : after.boundary())
    for (const NewVertex& v : c) vertices.emplace_back(v.at.x, v.at.y);
  std::sort(vertices.begin(), vertices.end());
  const auto is_vertex = [&](Point2 p) {
    return std::binary_search(vertices.begin(), vertices.end(), std::pair(p.x, p.y));
  };
  EXPECT_TRUE(is_vertex(q));
  EXPECT_GT(area(after), area(before) - 2 * perimeter(before));
  const auto nearest = nearest_perimeter_point(before, q, gap);
  ASSERT_TRUE(nearest.has_value());
  for (const auto& c : before.boundary())
    for (const NewVertex& v : c) {
      // The old polygon is contained, up to the rounding of cut points.
      if (after.locate(v.at) == Polygon::Side::outside) {
        ASSERT_LE(distance_to(after, v.at), 1.5);
      }
      if (!is_vertex(v.at)) {
        ASSERT_LT(squared_length(v.at - q), gap * gap);
      }
    }
  Polygon log = after;
  const auto removed = log.take_removed();
  EXPECT_NE(std::find(removed.begin(), removed.end(), before.node(nearest->edge).edge), removed.end())
      << "the nearest perimeter point does not lie on the section";
  for (std::uint32_t i = 0; i < before.slot_count(); ++i)
    if (before.alive(Slot{i}) && before.node(Slot{i}).shared) {
      EXPECT_EQ(std::count(removed.begin(), removed.end(), before.node(Slot{i}).edge), 0);
    }
  expect_identities_hold(before, after);
}

TEST(Extend, KeepsTheConditionsOnDegeneratePolygons) {
  int extended = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    EdgeIds ids;
    const double scale = random.chance(0.5) ? 1 : random.scale(1, 1e5);
    Polygon p = random_polygon(random, ids, scale, random.scale(1, 4e9));
    for (int k = 0; k < 25; ++k) {
      const double gap = std::floor(random.scale(2, 20) * scale);
      const Point2 q = telling_point(random, p, gap);
      const Polygon before = p;
      if (extend_to_point(p, q, gap, ids) == Extension::extended) {
        ++extended;
        expect_extended(before, p, q, gap);
      } else {
        ASSERT_TRUE(same_boundary(before, p));
      }
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(extended, 2000);
}

}  // namespace
}  // namespace limpet::geometry
