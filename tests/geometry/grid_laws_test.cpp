// Copyright the limpet authors. GPL-3.0-or-later.
//
// The numbered laws of round_to_grid() (predicates.hpp), edge_index.hpp, types.hpp and chart.hpp.
#include <Eigen/Geometry>

#include <limpet/geometry/chart.hpp>
#include <limpet/geometry/edge_index.hpp>

#include "laws.hpp"

namespace limpet::geometry {
namespace {

// round_to_grid

TEST(RoundToGridLaws, ItIsTheNearestGridPointTiesUp) {
  expect_law("round_to_grid (1) (2)", 5000, [] {
    double x = static_cast<double>(about_zero(1 << 20)) * power_of_two(-30, 40) +
               0.5 * static_cast<double>(about_zero(3));
    for (auto bits = about_zero(3); bits != 0; bits -= bits > 0 ? 1 : -1)
      x = std::nextafter(x, bits > 0 ? HUGE_VAL : -HUGE_VAL);
    RC_LOG() << std::setprecision(20) << x;
    const double rounded = round_to_grid({x, -7}).x;
    const auto twice = [](double v) { return 2 * whole_numbers::big(v); };
    const auto off = twice(rounded) - twice(x), half = whole_numbers::big(1.0);
    RC_ASSERT(rounded == std::floor(rounded));
    RC_ASSERT(-half < off && off <= half);
    RC_ASSERT(round_to_grid({rounded, rounded}) == (Point2{rounded, rounded}));
  });
}

TEST(RoundToGridLaws, StepsMoveItAlong) {
  expect_law("round_to_grid (3)", 3000, [] {
    const double x = static_cast<double>(about_zero(1 << 20)) * power_of_two(-10, 10),
                 by = static_cast<double>(about_zero(1 << 20)) * power_of_two(0, 20);
    RC_ASSERT(round_to_grid({x + by, by}) == (round_to_grid({x, 0}) + Point2{by, by}));
  });
}

// inside_even_odd

std::vector<Segment2> edges_of(const Cycles& cycles) {
  std::vector<Segment2> edges;
  for (const auto& cycle : cycles)
    for (std::size_t i = 0; i < cycle.size(); ++i)
      edges.emplace_back(cycle[i].at, cycle[(i + 1) % cycle.size()].at);
  return edges;
}

bool on_any(const std::vector<Segment2>& edges, Point2 p) {
  return std::any_of(edges.begin(), edges.end(),
                     [&](const auto& e) { return whole_numbers::on_segment(e.first, e.second, p); });
}

TEST(InsideEvenOddLaws, OrderAndDirectionOfEdgesDoNotMatter) {
  expect_law("inside_even_odd (1) (2) (3)", 1500, [] {
    const Boundary a = *boundaries(), b = *boundaries();
    auto edges = edges_of(a.cycles);
    const auto others = edges_of(b.cycles);
    const Point2 p = properties::telling_point(a.cycles, 2);
    if (on_any(edges, p) || on_any(others, p)) return;
    const bool inside = inside_even_odd(edges, p), other = inside_even_odd(others, p);
    std::reverse(edges.begin(), edges.end());
    for (std::size_t i = 0; i < edges.size(); i += 2) std::swap(edges[i].first, edges[i].second);
    RC_ASSERT(inside_even_odd(edges, p) == inside);
    edges.insert(edges.end(), others.begin(), others.end());
    RC_ASSERT(inside_even_odd(edges, p) == (inside != other));
    edges.insert(edges.end(), others.begin(), others.end());
    RC_ASSERT(inside_even_odd(edges, p) == inside);
  });
}

TEST(InsideEvenOddLaws, MotionsAndMirrorKeepIt) {
  expect_law("inside_even_odd (4)", 1500, [] {
    const Boundary a = *boundaries();
    const auto edges = edges_of(a.cycles);
    const Point2 p = properties::telling_point(a.cycles, 2);
    if (on_any(edges, p)) return;
    for (const shapes::Map& m : {any_motion(49), shapes::kMirror})
      RC_ASSERT(inside_even_odd(edges_of(shapes::mapped(a.cycles, m)), m(p)) == inside_even_odd(edges, p));
  });
}

// types.hpp

TEST(BoxLaws, TheyHoldWhatIsInThemAndMeetingIsSymmetric) {
  expect_law("Box2 (1) (2) (3)", 2000, [] {
    const auto [at] = *points_of_all_sizes<4>();
    const auto [a, b, c, d] = at;
    const Box2 ab = box_of(a, b), ba = box_of(b, a), cd = box_of(c, d);
    RC_ASSERT(ab.low == ba.low);
    RC_ASSERT(ab.high == ba.high);
    RC_ASSERT(ab.contains(a) && ab.contains(b) && ab.meets(ab));
    RC_ASSERT(ab.meets(cd) == cd.meets(ab));
    RC_ASSERT(!(ab.contains(c) && !ab.meets(cd)));
    RC_ASSERT(!ab.contains(c) || ab.squared_distance(c) == 0);
    RC_ASSERT(!Box2{}.meets(ab) && !Box2{}.contains(a));
  });
}

// chart

TEST(GridStepLaws, PowersOfTwoScaleItExactly) {
  expect_law("grid_step_for (1) (2)", 1000, [] {
    const double length = static_cast<double>(whole(1, 1 << 20)) * power_of_two(-60, 60);
    const double step = grid_step_for(length), scale = power_of_two(-60, 60);
    RC_ASSERT(step >= length / 4096 && step / 2 < length / 4096);
    RC_ASSERT(grid_step_for(scale * length) == scale * step);
  });
}

TEST(ChartLaws, ProjectionUndoesTheLiftAndALiftComesBackFromItsPlane) {
  expect_law("Chart (1), Lift (1) (2)", 1000, [] {
    using Eigen::Vector3d;
    const auto any = [](std::int64_t reach) {
      const auto x = static_cast<double>(about_zero(reach)), y = static_cast<double>(about_zero(reach)),
                 z = static_cast<double>(about_zero(reach));
      return Vector3d(x, y, z);
    };
    const Vector3d n = any(9), hint = any(9), tilt = any(9);
    RC_PRE(n.cross(hint).norm() > 0.1 * n.norm() * hint.norm());
    const double step = power_of_two(-12, 0);
    const Chart chart({step * any(1 << 20), n.normalized()}, hint, step);
    const Plane plane{chart.at(small_point(4000), 9),
                      (n.normalized() + 0.03 * tilt / (1 + tilt.norm())).normalized()};
    const Lift lift(chart, plane);
    const Point2 p = small_point(1 << 20);
    const Vector3d lifted = chart.at(p, lift(p));
    const Point2 back = chart.project(lifted);
    RC_ASSERT(std::abs(back.x - p.x) < 1e-6 && std::abs(back.y - p.y) < 1e-6);
    RC_ASSERT(std::abs(plane.height_of(lifted)) < 1e-6 * step);
    const Lift again(chart, lift.plane(chart));
    RC_ASSERT(std::abs(again(p) - lift(p)) < 1e-6);
  });
}

}  // namespace
}  // namespace limpet::geometry
