// Copyright the limpet authors. GPL-3.0-or-later.
#include <cmath>
#include <functional>
#include <numbers>

#include "../not_finite.hpp"
#include "hand_made.hpp"

namespace limpet::audit {
namespace {

// One mutation for each law, on the model that has everything.
struct LawCase {
  std::string law;
  std::string title;
  std::function<void(Document&)> harm;
};

std::vector<LawCase> header_cases() {
  return {
      {"finite", "resolution", [](Document& d) { d.resolution = kNaN; }},
      {"finite", "widening", [](Document& d) { d.widening = kNaN; }},
      {"finite", "sensor",
       [](Document& d) {
         d.sensors.push_back({0, kNaN, 0});
       }},
      {"parameters", "widening below 0", [](Document& d) { d.widening = -0.01; }},
      {"parameters", "widening above a quarter",
       [](Document& d) {
         d.widening = 0.26, d.sensors = {{0, 0, 0}};
       }},
      {"parameters", "widening from nowhere", [](Document& d) { d.widening = 0.1; }},
      {"finite", "angle", [](Document& d) { d.angle = kNaN; }},
      {"finite", "noise", [](Document& d) { d.noise = kInfinity; }},
      {"finite", "tolerance", [](Document& d) { d.tolerance = kInfinity; }},
      {"finite", "step", [](Document& d) { d.step = kNaN; }},
      {"finite", "point axis", [](Document& d) { point(d).axis_sum[1] = kNaN; }},
      {"finite", "raw position", [](Document& d) { point(d).raw[2].position[1] = kNaN; }},
      {"finite", "raw axis", [](Document& d) { point(d).raw[1].axis[2] = -kInfinity; }},
      {"finite", "origin", [](Document& d) { plate(d).origin[0] = kNaN; }},
      {"finite", "chart", [](Document& d) { plate(d).v[0] = kNaN; }},
      {"finite", "height", [](Document& d) { plate(d).hy = kNaN; }},
      {"finite", "initial", [](Document& d) { plate(d).initial_normal[2] = kNaN; }},
      {"finite", "vertex", [](Document& d) { plate(d).cycles[2][3].y = kInfinity; }},
      {"finite", "vertex of a shared edge", [](Document& d) { cube_face(d, 2).cycles[0][3].y = kNaN; }},
      {"parameters", "resolution 0", [](Document& d) { d.resolution = 0; }},
      {"parameters", "resolution below 0", [](Document& d) { d.resolution = -0.25; }},
      {"parameters", "angle 0", [](Document& d) { d.angle = 0; }},
      {"parameters", "right angle", [](Document& d) { d.angle = std::numbers::pi / 2; }},
      {"parameters", "noise", [](Document& d) { d.noise = -0x1p-1074; }},
      {"parameters", "tolerance", [](Document& d) { d.tolerance = -1; }},
      {"parameters", "step 0", [](Document& d) { d.step = 0; }},
      {"parameters", "step below 0", [](Document& d) { d.step = -kStep; }},
      {"parameters", "step next to a power of two",
       [](Document& d) {
         d = document_of({rectangle(0, 0, 9, 9)});
         d.step = std::nextafter(kStep, 1);
       }},
      {"parameters", "resolution below that of any model",
       [](Document& d) {
         d = empty_document();
         d.resolution = 1e-151;
         d.step = 0x1p-510;
       }},
      {"parameters", "resolution above that of any model",
       [](Document& d) {
         d = empty_document();
         d.resolution = 1e151;
         d.step = 0x1p490;
       }},
      {"parameters", "step above the resolution",
       [](Document& d) {
         d = empty_document();
         d.step = 1;
       }},
      {"parameters", "step far below the resolution",
       [](Document& d) {
         d = empty_document();
         d.step = 0x1p-40;
       }},
      {"segment-identity", "0", [](Document& d) { point(d).id = 0; }},
      {"segment-identity", "used twice", [](Document& d) { plate(d).id = point(d).id; }},
      {"segment-identity", "not below the next", [](Document& d) { --d.next_segment; }},
      {"edge-identity", "0", [](Document& d) { plate(d).cycles[1][1].edge = 0; }},
      {"edge-identity", "used twice",
       [](Document& d) { plate(d).cycles[1][1].edge = plate(d).cycles[0][3].edge; }},
      {"edge-identity", "not below the next", [](Document& d) { --d.next_edge; }},
      {"segment-count", "point segments", [](Document& d) { ++d.declared_points; }},
      {"segment-count", "polygon segments", [](Document& d) { --d.declared_polygons; }},
      {"point-count", "one lost", [](Document& d) { ++d.points; }},
      {"point-count", "one too many", [](Document& d) { ++d.expired; }},
      {"confirmed", "a polygon with data", [](Document& d) { ++d.points, ++plate(d).confirmed; }},
  };
}

std::vector<LawCase> fit_cases() {
  return {
      {"moments", "point segment without data", [](Document& d) { add_bare_point(d, {}); }},
      {"moments", "sums of nothing",
       [](Document& d) { d.points -= 4, plate(d).moments.m = 0, plate(d).axis_sum = {}; }},
      {"moments", "negative variance, by one",
       [](Document& d) {
         Moments moments = moments_of({{3, 4, 5}});
         --moments.product[3];
         add_bare_point(d, moments);
       }},
      {"moments", "correlation above 1",
       [](Document& d) {
         add_bare_point(d, centred(9, {100, 101, 0, 100, 0, 100}));
       }},
      {"moments", "correlation of the last pair",
       [](Document& d) {
         add_bare_point(d, centred(9, {100, 0, -101, 100, 0, 100}));
       }},
      {"moments", "first minor, determinant 0",
       [](Document& d) {
         add_bare_point(d, centred(9, {1, 2, 0, 1, 0, 0}));
       }},
      {"moments", "second minor, determinant 0",
       [](Document& d) {
         add_bare_point(d, centred(9, {0, 0, 0, 1, 2, 1}));
       }},
      {"moments", "third minor, determinant 0",
       [](Document& d) {
         add_bare_point(d, centred(9, {1, 0, 2, 0, 0, 1}));
       }},
      {"moments", "negative determinant",
       [](Document& d) {
         add_bare_point(d, centred(9, {10, -6, -6, 10, -6, 10}));
       }},
      {"raw", "one short", [](Document& d) { point(d).raw.pop_back(); }},
      {"raw", "one step off", [](Document& d) { point(d).raw[0].position[2] += 1; }},
      {"raw", "same sums, other products",
       [](Document& d) { ++point(d).raw[0].position[0], --point(d).raw[1].position[0]; }},
      {"axes", "no unit vector",
       [](Document& d) { point(d).raw[0].axis[2] = -1.00001, point(d).axis_sum[2] = -3.00001; }},
      {"axes", "another sum", [](Document& d) { point(d).axis_sum[0] = 0.01; }},
      {"axes", "longer than m", [](Document& d) { plate(d).axis_sum[2] *= 1.001; }},
      {"point-variance", "exactly resolution^2",
       [](Document& d) { add_bare_point(d, apart(kResolutionSteps)); }},
      {"plane-variance", "exactly resolution^2",
       [](Document& d) { plate(d).h0 += static_cast<double>(kResolutionSteps); }},
      {"plane-variance", "plane on the other side",
       [](Document& d) { plate(d).h0 -= static_cast<double>(kResolutionSteps); }},
      {"chart", "left-handed", [](Document& d) { plate(d).n[2] = -1; }},
      {"chart", "n too long", [](Document& d) { plate(d).n[2] = 1 + 1e-8; }},
      {"chart", "u too short", [](Document& d) { plate(d).u[0] = 1 - 1e-8; }},
      {"chart", "u and v not at right angles", [](Document& d) { plate(d).v[0] = 1e-8; }},
      {"chart", "n not at right angles", [](Document& d) { plate(d).n[1] = 1e-8; }},
      {"chart", "an initial normal of another length",
       [](Document& d) { plate(d).initial_normal[2] = 1 + 1e-8; }},
      {"tilt", "3.01 degrees", [](Document& d) { plate(d).hx = std::tan(3.01 * std::numbers::pi / 180); }},
      {"tilt", "both slopes", [](Document& d) { plate(d).hx = plate(d).hy = -0.0371; }},
      {"outward", "sensed from behind", [](Document& d) { plate(d).axis_sum[2] = 0x1p-1074; }},
      {"outward", "sensed edge-on",
       [](Document& d) {
         plate(d).axis_sum = {4, 0, 0};
       }},
  };
}

std::vector<LawCase> perimeter_cases() {
  const auto outer = [](Document& d) -> Cycle& { return plate(d).cycles[0]; };
  const auto first_hole = [](Document& d) -> Cycle& { return plate(d).cycles[1]; };
  const auto put = [](Document& d, Cycle& cycle, std::size_t before, double x, double y) {
    cycle.insert(cycle.begin() + static_cast<std::ptrdiff_t>(before), {x, y, d.next_edge++, 0});
  };
  const auto move = [](Cycle& cycle, double x, double y) {
    for (Vertex& p : cycle) p.x += x, p.y += y;
  };
  const auto set = [](Cycle& hole, const Outline& outline) {
    for (std::size_t i = 0; i < 4; ++i) hole[i].x = outline[3 - i].x, hole[i].y = outline[3 - i].y;
  };
  const auto flip = [](Cycle& cycle) { std::reverse(cycle.begin(), cycle.end()); };
  return {
      {"grid", "half a step", [=](Document& d) { outer(d)[2].x += 0.5; }},
      {"grid", "a raw point between grid points",
       [](Document& d) {
         Segment& s = point(d);
         s.raw.assign(4, RawPoint{{0.5, 0, 0}, {0, 0, -1}, 0});
         s.moments = centred(4, {1, 0, 0, 0, 0, 0});
         s.moments.sum[0] = 2;
         s.axis_sum = {0, 0, -4};
         ++d.points;
       }},
      {"grid", "a point beyond 2^48 steps",
       [](Document& d) {
         add_bare_point(d, moments_of({{(std::int64_t{1} << 48) + 1, 0, 0}}));
       }},
      {"grid", "an initial centroid beyond 2^49 steps",
       [](Document& d) { plate(d).initial_centroid[1] = -0x1.0000000000001p49 * kStep; }},
      {"grid", "beyond 2^40", [=](Document& d) { outer(d)[2].x = 0x1p40 + 1; }},
      {"cycle-size", "no cycle", [](Document& d) { plate(d).cycles.clear(); }},
      {"cycle-size", "empty hole", [=](Document& d) { first_hole(d).clear(); }},
      {"cycle-size", "two vertices", [=](Document& d) { first_hole(d).resize(2); }},
      {"edge-length", "repeated vertex", [=](Document& d) { put(d, outer(d), 2, 1000, 1000); }},
      {"edge-length", "last and first", [=](Document& d) { put(d, first_hole(d), 4, 100, 300); }},
      {"edge-length", "a hole that is a point",
       [=](Document& d) {
         for (Vertex& p : first_hole(d)) p.x = p.y = 200;
       }},
      {"simple", "a notch that touches the far side", [=](Document& d) { put(d, outer(d), 3, 400, 0); }},
      {"simple", "a notch that crosses the far side by a step",
       [=](Document& d) { put(d, outer(d), 3, 400, -1); }},
      {"simple", "spike", [=](Document& d) { put(d, outer(d), 4, 0, 1001), put(d, outer(d), 5, 0, 1000); }},
      {"simple", "flat spike of one step",
       [=](Document& d) {
         put(d, outer(d), 4, -1, 1000);
         outer(d)[3].x = 1, put(d, outer(d), 5, 0, 1000);
       }},
      {"simple", "bow tie", [=](Document& d) { std::swap(outer(d)[2].x, outer(d)[3].x); }},
      {"simple", "hole vertex on the outer edge", [=](Document& d) { first_hole(d)[3].x = 0; }},
      {"simple", "hole vertex on the outer vertex",
       [=](Document& d) { first_hole(d)[3].x = first_hole(d)[3].y = 0; }},
      {"simple", "hole edge along the outer edge", [=](Document& d) { move(first_hole(d), -100, 0); }},
      {"simple", "hole through the outer cycle by a step",
       [=](Document& d) { move(first_hole(d), -101, 0); }},
      {"simple", "hole vertex on another hole's", [=](Document& d) { move(first_hole(d), 200, 200); }},
      {"simple", "holes overlap", [=](Document& d) { move(first_hole(d), 201, 201); }},
      {"simple", "the same hole twice",
       [=](Document& d) { set(first_hole(d), rectangle(500, 500, 900, 900)); }},
      {"direction", "outer clockwise", [=](Document& d) { flip(outer(d)); }},
      {"direction", "hole anticlockwise", [=](Document& d) { flip(first_hole(d)); }},
      {"nesting", "hole outside by a step", [=](Document& d) { move(first_hole(d), -301, 0); }},
      {"nesting", "hole about the outer cycle",
       [=](Document& d) {
         plate(d).cycles.pop_back();
         set(first_hole(d), rectangle(-1, -1, 1001, 1001));
       }},
      {"nesting", "hole in an earlier hole",
       [=](Document& d) {
         move(first_hole(d), 450, 500), std::swap(plate(d).cycles[1], plate(d).cycles[2]);
       }},
      {"nesting", "hole in a hole", [=](Document& d) { move(first_hole(d), 450, 500); }},
  };
}

std::vector<LawCase> shared_cases() {
  const auto shared_edge = [](Document& d) -> Vertex& { return cube_face(d, 0).cycles[0][0]; };
  return {
      {"partner", "does not exist", [](Document& d) { plate(d).cycles[0][0].partner = 999999; }},
      {"partner", "does not share back",
       [=](Document& d) { plate(d).cycles[0][0].partner = shared_edge(d).edge; }},
      {"partner", "shared one way",
       [=](Document& d) {
         plate(d).cycles[0][0].partner = cube_face(d, 0).cycles[0][0].partner, shared_edge(d).partner = 0;
       }},
      {"partner", "itself", [](Document& d) { plate(d).cycles[0][0].partner = plate(d).cycles[0][0].edge; }},
      {"partner", "same segment", [](Document& d) { share(plate(d).cycles[0][0], plate(d).cycles[1][0]); }},
      {"shared-line", "parallel planes",
       [](Document& d) {
         d = document_of({rectangle(0, 0, 100, 100)});
         Frame next;
         next.origin = {100, 0, 0};
         add_polygon(d, next, {rectangle(0, 0, 100, 100)});
         share(vertex_at(d, 0, {100, 0}), vertex_at(d, 1, {0, 100}));
       }},
      {"shared-line", "a step too high", [](Document& d) { d = roof(0, 3); }},
      {"shared-line", "a step too low", [](Document& d) { d = roof(0, -3); }},
      {"shared-line", "a step too far", [](Document& d) { d = roof(0, 0, 3); }},
      {"shared-line", "one end",
       [](Document& d) {
         d = roof(), vertex_at(d, 1, {1000, 0}).y = 3;
       }},
      {"shared-line", "the published plane", [](Document& d) { d = roof(), d.polygons[0].h0 = 3; }},
      {"shared-direction", "wall of the wrong side",
       [](Document& d) {
         d = neighbours(rectangle(-800, 0, 0, 1000), rectangle(-1000, -800, 0, 0), {{{0, 0}, {0, 0}}},
                        kWestWall);
       }},
      {"shared-ends", "a step too far along", [](Document& d) { d = roof(5); }},
      {"shared-ends", "a step too far back", [](Document& d) { d = roof(-5); }},
      {"concavity", "one convex, one concave", [](Document& d) { d = both_concavities(); }},
      {"local-order", "1 3 2", [](Document& d) { d = twisted(); }},
      {"global-order", "west east west east", [](Document& d) { d = alternating(); }},
  };
}

std::vector<LawCase> all_cases() {
  std::vector<LawCase> all;
  for (const auto& cases : {header_cases(), fit_cases(), perimeter_cases(), shared_cases()})
    all.insert(all.end(), cases.begin(), cases.end());
  return all;
}

TEST(Laws, ABrokenLawIsNamedAndNoOther) {
  for (const LawCase& c : all_cases()) {
    Document document = everything();
    c.harm(document);
    EXPECT_EQ(broken(document), Names{c.law}) << c.law << ": " << c.title;
  }
}

TEST(Laws, EveryLawIsBrokenBySomeTest) {
  Names tested = {"shared-overlap"};  // Laws.CopiesThatDoNotOverlapDoNotMeetEither
  for (const LawCase& c : all_cases()) tested.insert(c.law);
  Names listed;
  for (const Law& law : laws()) {
    EXPECT_TRUE(listed.insert(law.name).second) << law.name;
    EXPECT_FALSE(law.statement.empty());
  }
  EXPECT_EQ(tested, listed);
}

TEST(Laws, AViolationSaysWhere) {
  Document document = everything();
  plate(document).cycles[2][1].x += 0.5;
  const auto violations = judge(document);
  ASSERT_EQ(violations.size(), 1u);
  EXPECT_EQ(violations[0].where, "segment 2 cycle 2 vertex 1");
}

TEST(Laws, CopiesThatDoNotOverlapDoNotMeetEither) {
  EXPECT_EQ(broken(roof(1000)), (Names{"shared-overlap", "shared-ends"}));
  EXPECT_EQ(broken(roof(-1000)), (Names{"shared-overlap", "shared-ends"}));
  EXPECT_EQ(broken(roof(999)), Names{"shared-ends"});
}

}  // namespace
}  // namespace limpet::audit
