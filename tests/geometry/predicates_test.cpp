// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/geometry/predicates.hpp>

#include "perimeters.hpp"

namespace limpet::geometry {
namespace {

__extension__ typedef __int128 Int128;

/// Whole coordinates below 2^40 only.
int orientation_by_whole_numbers(Point2 p, Point2 q, Point2 r) {
  const auto whole = [](double x) { return static_cast<Int128>(static_cast<std::int64_t>(x)); };
  const Int128 d = (whole(q.x) - whole(p.x)) * (whole(r.y) - whole(p.y)) -
                   (whole(q.y) - whole(p.y)) * (whole(r.x) - whole(p.x));
  return d > 0 ? 1 : d < 0 ? -1 : 0;
}

bool meet_by_whole_numbers(Point2 a, Point2 b, Point2 c, Point2 d) {
  const auto o = orientation_by_whole_numbers;
  const auto on = [&](Point2 p, Point2 q, Point2 r) { return o(p, q, r) == 0 && box_of(p, q).contains(r); };
  if (on(a, b, c) || on(a, b, d) || on(c, d, a) || on(c, d, b)) return true;
  return o(a, b, c) * o(a, b, d) < 0 && o(c, d, a) * o(c, d, b) < 0;
}

/// Nearly on one line, or exactly, with coordinates of all sizes.
struct Triple {
  Point2 p, q, r;
};
Triple nearly_collinear(Random& random) {
  const double reach = std::floor(random.scale(1, 0x1p39));
  const auto any = [&] { return std::floor((2 * random.unit() - 1) * reach); };
  const Point2 p{any(), any()}, q{any(), any()};
  Point2 r = round_to_grid(p + (3 * random.unit() - 1) * (q - p));
  if (random.chance(0.3)) r = r + Point2{static_cast<double>(random.whole(-1, 1)), 0};
  if (random.chance(0.1)) r = random.chance(0.5) ? p : q;
  return {p, q, r};
}

TEST(Orientation, IsTheSignOfTheExactDeterminant) {
  Random random(11);
  for (int k = 0; k < 100000; ++k) {
    const auto [p, q, r] = nearly_collinear(random);
    ASSERT_EQ(orientation(p, q, r), orientation_by_whole_numbers(p, q, r)) << "case " << k;
  }
}

TEST(Orientation, KeepsItsLaws) {
  Random random(12);
  for (int k = 0; k < 20000; ++k) {
    const auto [p, q, r] = nearly_collinear(random);
    const int o = orientation(p, q, r);
    ASSERT_EQ(o, orientation(q, r, p));
    ASSERT_EQ(o, -orientation(q, p, r));
    ASSERT_EQ(orientation(p, q, p), 0);
    ASSERT_EQ(orientation(p, p, q), 0);
  }
}

TEST(SegmentsMeet, AgreesWithWholeNumbersAndIsSymmetric) {
  Random random(13);
  int met = 0;
  for (int k = 0; k < 60000; ++k) {
    const auto tiny = [&] {
      return Point2{static_cast<double>(random.whole(0, 4)), static_cast<double>(random.whole(0, 4))};
    };
    Point2 a = tiny(), b = tiny(), c = tiny(), d = tiny();
    if (random.chance(0.5)) {
      const Triple t = nearly_collinear(random);
      a = t.p, b = t.q, c = t.r, d = nearly_collinear(random).r;
    }
    const bool meet = segments_meet(a, b, c, d);
    met += meet;
    ASSERT_EQ(meet, meet_by_whole_numbers(a, b, c, d)) << "case " << k;
    ASSERT_EQ(meet, segments_meet(c, d, a, b));
    ASSERT_EQ(meet, segments_meet(b, a, c, d));
    ASSERT_EQ(meet, segments_meet(a, b, d, c));
  }
  EXPECT_GT(met, 10000);
}

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

TEST(ChainOrientation, IsTheSignOfTheArea) {
  Random random(14);
  EdgeIds ids;
  for (int k = 0; k < 500; ++k) {
    const Polygon p = random_polygon(random, ids, random.scale(1, 1000), random.scale(1, 1e9));
    for (const auto& c : p.cycles()) {
      auto points = points_of(p.vertices(c));
      ASSERT_EQ(chain_orientation(points), c.hole ? -1 : 1);
      std::reverse(points.begin(), points.end());
      ASSERT_EQ(chain_orientation(points), c.hole ? 1 : -1);
    }
  }
}

TEST(RoundToGrid, TiesGoUp) {
  EXPECT_EQ(round_to_grid({0.5, -0.5}), (Point2{1, 0}));
  EXPECT_EQ(round_to_grid({1.49, -1.51}), (Point2{1, -2}));
  EXPECT_EQ(round_to_grid({7, -7}), (Point2{7, -7}));
}

}  // namespace
}  // namespace limpet::geometry
