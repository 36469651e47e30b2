// Copyright the limpet authors. GPL-3.0-or-later.
//
// The numbered laws of cut.hpp, and known cuts.
#include <limpet/geometry/cut.hpp>

#include "laws.hpp"

namespace limpet::geometry {
namespace {

std::vector<Point2> points_of(const std::vector<std::vector<NewVertex>>& cycles) {
  std::vector<Point2> points;
  for (const auto& cycle : cycles)
    for (const NewVertex& v : cycle) points.push_back(v.at);
  return points;
}

std::size_t times(const std::vector<Point2>& points, Point2 p) {
  return static_cast<std::size_t>(std::count(points.begin(), points.end(), p));
}

/// What the cut leaves of the polygon.
Polygon rest_of(Polygon polygon, const Cut& cut, EdgeIds& ids) {
  polygon.commit(cut.rest, ids);
  return polygon;
}

TEST(CutLaws, TwoValidPartsThatAreTheWhole) {
  expect_law("cut_off (1) (2) (3)", Cases{3000, 0.05}, [] {
    EdgeIds ids;
    const Polygon whole_one = make((*polygons()).cycles, ids);
    const auto all = points_of(whole_one.boundary());
    const auto any = [&] { return all[static_cast<std::size_t>(whole(0, 999)) % all.size()]; };
    // From beside one vertex, through another part, to beyond it.
    const Point2 near = any() + Point2{static_cast<double>(whole(-9, 9)), static_cast<double>(whole(-9, 9))},
                 far = any() + Point2{static_cast<double>(whole(-9, 9)), static_cast<double>(whole(-9, 9))};
    const Point2 a = round_to_grid(near + 0.25 * (near - far)), b = round_to_grid(far + 0.25 * (far - near));
    const auto cut = cut_off(whole_one, a, b, ids);
    RC_CLASSIFY(cut.has_value());
    if (!cut) return;
    const Polygon rest = rest_of(whole_one, *cut, ids);
    expect_valid(rest);
    expect_valid(cut->piece);
    const auto of_rest = points_of(rest.boundary()), of_piece = points_of(cut->piece.boundary());
    RC_ASSERT(of_rest.size() + of_piece.size() <= all.size() + 4);
    for (const Point2 p : all) RC_ASSERT(times(of_rest, p) + times(of_piece, p) >= 1u);
    const double steps = 2 * (std::sqrt(squared_length(b - a)) + perimeter(whole_one));
    RC_ASSERT(std::abs(exact_area(rest.boundary()) + exact_area(cut->piece.boundary()) -
                       exact_area(whole_one.boundary())) <= steps);
    RC_ASSERT(rest.hole_count() + cut->piece.hole_count() <= whole_one.hole_count());
  });
}

/// Two squares of 100, one step up and one to the right of the other, joined by a neck round (100, 100).
Polygon two_squares(EdgeIds& ids) {
  return make({{{{0, 0}},
                {{100, 0}},
                {{100, 90}},
                {{110, 100}},
                {{200, 100}},
                {{200, 200}},
                {{100, 200}},
                {{100, 110}},
                {{90, 100}},
                {{0, 100}}}},
              ids);
}

TEST(Cut, ThroughANeck) {
  EdgeIds ids;
  const Polygon both = two_squares(ids);
  const auto cut = cut_off(both, {120, 80}, {80, 120}, ids);
  ASSERT_TRUE(cut);
  const Polygon rest = rest_of(both, *cut, ids);
  EXPECT_EQ(rest.area(), both.area() / 2);
  EXPECT_EQ(cut->piece.area(), both.area() / 2);
  EXPECT_EQ(rest.edge_count() + cut->piece.edge_count(), 14u);
  const Point2 low{50, 50}, high{150, 150};
  EXPECT_NE(rest.locate(low) == Polygon::Side::inside, rest.locate(high) == Polygon::Side::inside);
  EXPECT_NE(rest.locate(low), cut->piece.locate(low));
}

/// A square ring with a slit: what is cut off lies within the new hole.
TEST(Cut, AcrossTheMouthOfAHole) {
  EdgeIds ids;
  const Polygon bay = make({{{{0, 0}}, {{300, 0}}, {{300, 300}}, {{0, 300}}},
                            // a hole in the shape of a C, open to the right
                            {{{50, 50}},
                             {{50, 250}},
                             {{250, 250}},
                             {{250, 240}},
                             {{60, 240}},
                             {{60, 60}},
                             {{250, 60}},
                             {{250, 50}}}},
                           ids);
  const auto cut = cut_off(bay, {240, 55}, {240, 245}, ids);
  ASSERT_TRUE(cut);
  const Polygon rest = rest_of(bay, *cut, ids);
  EXPECT_EQ(cut->piece.area(), 180.0 * 180);
  EXPECT_EQ(rest.area(), bay.area() - 180.0 * 180);
  EXPECT_EQ(rest.hole_count(), 1u);
}

TEST(Cut, OfWhatItIsNot) {
  EdgeIds ids;
  const Polygon both = two_squares(ids);
  EXPECT_FALSE(cut_off(both, {120, 80}, {100, 100}, ids)) << "ends inside";
  EXPECT_FALSE(cut_off(both, {120, 80}, {110, 90}, ids)) << "passes by";
  EXPECT_FALSE(cut_off(both, {100, 80}, {100, 220}, ids)) << "along an edge";
  const Polygon ring = make({{{{0, 0}}, {{300, 0}}, {{300, 300}}, {{0, 300}}},
                             {{{100, 100}}, {{100, 200}}, {{200, 200}}, {{200, 100}}}},
                            ids);
  EXPECT_FALSE(cut_off(ring, {150, -10}, {150, 110}, ids)) << "from one cycle to another, nothing falls off";
  EXPECT_FALSE(cut_off(ring, {150, -10}, {150, 310}, ids)) << "in and out twice";
  const auto corner = cut_off(ring, {-10, 50}, {50, -10}, ids);
  ASSERT_TRUE(corner);
  EXPECT_EQ(corner->piece.area(), 20.0 * 20 / 2 * 4);
}

}  // namespace
}  // namespace limpet::geometry
