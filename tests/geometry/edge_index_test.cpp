// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/geometry/edge_index.hpp>

#include "perimeters.hpp"

namespace limpet::geometry {
namespace {

std::vector<Segment2> loop(std::initializer_list<Point2> points) {
  std::vector<Segment2> edges;
  for (std::size_t i = 0; i < points.size(); ++i)
    edges.emplace_back(points.begin()[i], points.begin()[(i + 1) % points.size()]);
  return edges;
}

TEST(InsideEvenOdd, CountsOncePerVertexOnTheRay) {
  const auto diamond = loop({{0, -5}, {5, 0}, {0, 5}, {-5, 0}});
  EXPECT_TRUE(inside_even_odd(diamond, {-1, 0}));  // the ray leaves by a vertex
  EXPECT_FALSE(inside_even_odd(diamond, {-9, 0}));
  EXPECT_FALSE(inside_even_odd(diamond, {-9, 5}));
  const auto steps = loop({{0, 0}, {9, 0}, {9, 3}, {6, 3}, {6, 6}, {0, 6}});
  EXPECT_TRUE(inside_even_odd(steps, {1, 3}));  // the ray runs along an edge
  EXPECT_FALSE(inside_even_odd(steps, {-1, 3}));
}

TEST(InsideEvenOdd, IsTheSumOfTwoLoops) {
  auto two = loop({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  const auto other = loop({{5, 5}, {20, 5}, {20, 9}, {5, 9}});
  two.insert(two.end(), other.begin(), other.end());
  EXPECT_TRUE(inside_even_odd(two, {2, 7}));
  EXPECT_FALSE(inside_even_odd(two, {7, 7}));
  EXPECT_TRUE(inside_even_odd(two, {15, 7}));
}

TEST(EvenOdd, SaysTheSameWithAnIndex) {
  for (const double place : {0.0, 0x1p31}) {
    Random random(7);
    const auto any = [&](double beside) {
      return Point2{place + static_cast<double>(random.whole(0, 300)) + beside,
                    place + static_cast<double>(random.whole(0, 300))};
    };
    std::vector<Segment2> edges;  // chains that cross themselves and each other, one of them twice
    for (const int vertices : {3, 90, 40}) {
      std::vector<Point2> chain;
      for (int i = 0; i < vertices; ++i) chain.push_back(any(0));
      for (std::size_t i = 0; i < chain.size(); ++i)
        edges.emplace_back(chain[i], chain[(i + 1) % chain.size()]);
    }
    for (std::size_t i = 93; i < 133; ++i) edges.push_back(edges[i]);
    EvenOdd region(edges);
    for (int k = 0; k < 2000; ++k) {
      const Point2 p = any(0x1p-10);
      const bool on_edge = std::any_of(edges.begin(), edges.end(), [&](const Segment2& e) {
        return orientation(e.first, e.second, p) == 0 && box_of(e.first, e.second).contains(p);
      });
      if (on_edge) continue;
      ASSERT_EQ(region.inside(p), inside_even_odd(edges, p)) << p.x << " " << p.y;
    }
    EXPECT_FALSE(region.inside({place - 1000, place}));
  }
}

/// An index over a closed boundary whose cells' sides are asked of every cell.
void expect_references_hold(const EdgeIndex& index, const std::vector<Segment2>& edges, const Box2& box) {
  for (double x = box.low.x; x <= box.high.x; x += 3)
    for (double y = box.low.y; y <= box.high.y; y += 3)
      ASSERT_EQ(index.cell_at({x, y}).inside, inside_even_odd(edges, index.reference_at({x, y})))
          << x << " " << y;
}

TEST(EdgeIndex, FlipsTheReferencesASweepPassesOver) {
  const auto square = loop({{0, 0}, {300, 0}, {300, 300}, {0, 300}});
  for (const double place : {0.0, 0x1p31}) {  // beyond 2^26 steps references may lie on an edge
    EdgeIndex index;
    std::vector<Segment2> edges;
    for (const auto& [a, b] : square) edges.emplace_back(a + Point2{place, place}, b + Point2{place, place});
    const Box2 placed{{place, place}, {place + 300, place + 300}};
    index.reset(placed, 400);
    for (std::uint32_t i = 0; i < 4; ++i) index.add(i, edges[i].first, edges[i].second);
    index.flip(edges);
    expect_references_hold(index, edges, placed);
    Random random(21);
    for (int k = 0; k < 40; ++k) {
      const auto any = [&] {
        return Point2{place + static_cast<double>(random.whole(0, 300)),
                      place + static_cast<double>(random.whole(0, 300))};
      };
      const auto sweep = loop({any(), any(), any()});
      edges.insert(edges.end(), sweep.begin(), sweep.end());
      index.flip(sweep);
    }
    expect_references_hold(index, edges, placed);
  }
}

TEST(EdgeIndex, SlantedEdgesAreFoundWhereTheyPass) {
  Random random(22);
  for (int k = 0; k < 300; ++k) {
    const double side = random.scale(100, 4e9);
    const Box2 box{{-side, -side}, {side, side}};
    EdgeIndex index;
    index.reset(box, static_cast<std::size_t>(random.whole(24, 6000)));
    const auto any = [&] { return std::floor((2 * random.unit() - 1) * side); };
    Point2 a{any(), any()}, b{any(), any()};
    if (random.chance(0.5)) b.y = a.y + static_cast<double>(random.whole(-2, 2));
    if (random.chance(0.2)) b.x = a.x + static_cast<double>(random.whole(-2, 2));
    index.add(7, a, b);
    for (int i = 0; i < 100; ++i) {
      const Point2 p = round_to_grid(a + random.unit() * (b - a));
      const Box2 around = box_of(p, p).grown(1);  // the edge passes through it
      ASSERT_TRUE(index.any_near(around, 8, [](std::uint32_t s) { return s == 7; })) << "case " << k;
    }
    index.remove(7, a, b);
    ASSERT_FALSE(index.any_near(box, 8, [](std::uint32_t s) { return s == 7; }));
  }
}

TEST(EdgeIndex, FitsOnlyWhatItWasBuiltFor) {
  EdgeIndex index;
  const Box2 box{{0, 0}, {1000, 1000}};
  EXPECT_TRUE(index.fits(box, EdgeIndex::kMinimum - 1));
  EXPECT_FALSE(index.fits(box, EdgeIndex::kMinimum));
  index.reset(box, 100);
  EXPECT_TRUE(index.fits(box, 100));
  EXPECT_TRUE(index.fits(box.grown(200), 100));
  EXPECT_FALSE(index.fits(box.grown(300), 100));
  EXPECT_FALSE(index.fits(box, 401));
  EXPECT_FALSE(index.fits(box, EdgeIndex::kMinimum - 1));
}

}  // namespace
}  // namespace limpet::geometry
