// Copyright the limpet authors. GPL-3.0-or-later.
#include <cmath>
#include <numbers>

#include "hand_made.hpp"

namespace limpet::audit {
namespace {

// --- shared edges
// -------------------------------------------------------------------------------------------

TEST(SharedEdges, ConcaveNeighboursPass) {
  // A wall that rises east of the floor and faces west.
  const Document document =
      neighbours(rectangle(-800, 0, 0, 1000), rectangle(-1000, 0, 0, 800), {{{0, 0}, {-1000, 0}}}, kWestWall);
  EXPECT_EQ(broken(document), kNothing);
}

// Along the wall's chart a roof of 10 degrees may miss the line by 2 / sin 10° = 11.5 steps.
TEST(SharedEdges, TheSharperTheAngleTheFartherTheLine) {
  const double theta = 10 * std::numbers::pi / 180;
  for (const int gap : {0, 11, -11, 12, -12}) {
    Document document = roof();
    Polygon& slope = document.polygons[1];
    slope.v = {-std::cos(theta), 0, std::sin(theta)};
    slope.n = {std::sin(theta), 0, std::cos(theta)};
    slope.moments = {};
    slope.axis_sum = {};
    document.points = document.polygons[0].moments.m;
    for (Vertex& p : slope.cycles[0])
      if (p.y == 0) p.y = gap;
    EXPECT_EQ(broken(document), std::abs(gap) > 11 ? Names{"shared-line"} : kNothing) << gap;
  }
}

TEST(SharedEdges, CornersNeedNotMeet) {
  Document document = everything();
  // The face moves 5 steps along its edges with two neighbours, and stays on all common lines of these.
  Polygon& face = cube_face(document, 4);
  for (Vertex& p : face.cycles[0]) p.x += p.x > 0 ? 2 : -2;
  EXPECT_EQ(broken(document), kNothing);
  for (Vertex& p : face.cycles[0]) p.x += p.x > 0 ? 1 : -1;
  EXPECT_EQ(broken(document), Names{"shared-line"});
}

/// A wall above the floor on the left, and above nothing on the right, where its foot is that of a ceiling
/// that lies `up` steps higher: its corner is on neither of the two lines.
Document on_two_floors(std::int64_t up, double corner) {
  Document d = empty_document();
  const Frame wall = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
  const Frame ceiling = {{0, 0, up}, {1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  add_polygon(d, wall,
              {{{-1000, 0}, {0, corner}, {1000, static_cast<double>(up)}, {1000, 1000}, {-1000, 1000}}});
  add_polygon(d, kFloor, {rectangle(-1000, -1000, 0, 0)});
  add_polygon(d, ceiling, {rectangle(0, -1000, 1000, 0)});
  share(vertex_at(d, 0, {-1000, 0}), vertex_at(d, 1, {0, 0}));
  share(vertex_at(d, 0, {0, corner}), vertex_at(d, 2, {1000, 0}));
  return d;
}

// Where two planes are parallel or nearly so, a corner may be a quarter of the resolution from their lines.
TEST(SharedEdges, WhereLinesRunOnTheCornerNeedNotBeOnThem) {
  const auto quarter = static_cast<std::int64_t>(empty_document().resolution / empty_document().step / 4);
  EXPECT_EQ(broken(on_two_floors(0, 0)), kNothing);
  EXPECT_EQ(broken(on_two_floors(quarter, 0.5 * static_cast<double>(quarter))), kNothing);
  EXPECT_EQ(broken(on_two_floors(quarter, static_cast<double>(quarter))), kNothing);
  EXPECT_EQ(broken(on_two_floors(quarter + 1, static_cast<double>(quarter + 1))), Names{"shared-line"});
  EXPECT_EQ(broken(on_two_floors(quarter + 1, 0)), Names{"shared-line"});
}

// At an angle with a sine above a fifth they say where it is.
TEST(SharedEdges, WhereLinesTurnTheCornerIsOnThem) {
  for (const double corner : {0, 5}) {
    Document d = on_two_floors(0, corner);
    Vertex& end = vertex_at(d, 0, {1000, 0});
    end.x = 960, end.y = 280;
    Polygon& slope = d.polygons[2];
    d.points -= slope.moments.m;
    slope.moments = {};
    slope.axis_sum = {};
    slope.u = {0.96, 0, 0.28};
    slope.n = slope.initial_normal = {0.28, 0, -0.96};
    EXPECT_EQ(broken(d), corner > 0 ? Names{"shared-line"} : kNothing);
  }
}

TEST(SharedEdges, OpenEndsMustMeet) {
  Document document = roof();
  vertex_at(document, 1, {1000, 0}).x = 900;
  EXPECT_EQ(broken(document), Names{"shared-ends"});
}

TEST(SharedEdges, ACornerNeedNotMeetAnOpenEnd) {
  Document document = roof();
  vertex_at(document, 1, {1000, 0}).x = 900;
  EXPECT_EQ(broken(document), Names{"shared-ends"});
  const Frame north = {{0, 1000, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 1, 0}};
  add_polygon(document, north, {rectangle(0, -800, 800, 0)});
  share(vertex_at(document, 0, {0, 1000}), vertex_at(document, 2, {800, 0}));
  EXPECT_EQ(broken(document), kNothing);
}

TEST(SharedEdges, TheLineIsThatOfThePublishedPlanes) {
  // A floor that rises northwards by 1 in 64, and a wall under its east side.
  Document document = neighbours(rectangle(-800, 0, 0, 6400), {{0, -800}, {6400, -800}, {6400, 100}, {0, 0}},
                                 {{{0, 0}, {6400, 100}}});
  EXPECT_EQ(broken(document), (Names{"shared-line", "shared-ends"}));
  document.polygons[0].hy = 1 / 64.0;
  EXPECT_EQ(broken(document), kNothing);
  vertex_at(document, 1, {6400, 100}).y = 102;
  EXPECT_EQ(broken(document), kNothing);
  vertex_at(document, 1, {6400, 102}).y = 103;
  EXPECT_EQ(broken(document), Names{"shared-line"});
}

TEST(SharedEdges, NestedNeighboursPass) {
  // Two walls, each met twice, one between the other's edges: a b b a.
  Document document = alternating();
  for (Vertex* e : {&vertex_at(document, 0, {0, 500}), &vertex_at(document, 1, {-400, 0})}) e->partner = 0;
  EXPECT_EQ(broken(document), kNothing);
}

TEST(SharedEdges, OrderIsCyclic) {
  // Which vertex a cycle begins with means nothing.
  for (std::size_t s = 0; s < 2; ++s)
    for (std::ptrdiff_t turn = 0; turn < 12; ++turn) {
      Document document = combs();
      Cycle& cycle = document.polygons[s].cycles[0];
      std::rotate(cycle.begin(), cycle.begin() + turn, cycle.end());
      EXPECT_EQ(broken(document), kNothing) << turn;
      document = twisted();
      Cycle& other = document.polygons[s].cycles[0];
      std::rotate(other.begin(), other.begin() + turn, other.end());
      EXPECT_EQ(broken(document), Names{"local-order"}) << turn;
      document = alternating();
      Cycle& floor = document.polygons[0].cycles[0];
      std::rotate(floor.begin(), floor.begin() + turn, floor.end());
      EXPECT_EQ(broken(document), Names{"global-order"}) << turn;
    }
}

}  // namespace
}  // namespace limpet::audit
