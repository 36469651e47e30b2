// Copyright the limpet authors. GPL-3.0-or-later.
//
// The numbered laws of search.hpp.
#include <limpet/geometry/search.hpp>

#include "laws.hpp"

namespace limpet::geometry {
namespace {

// sights

SightEnd any_end(const Polygon& p, const Cycles& cycles) {
  if (one_of(2) == 0) {
    const Slot s = any_slot(p);
    return {p.at(s), s};
  }
  return {properties::telling_point(cycles, 4)};
}

TEST(SightsLaws, ItIsSymmetric) {
  expect_law("sights (1)", 2000, [] {
    EdgeIds ids;
    const Boundary b = *polygons();
    const Polygon p = make(b.cycles, ids);
    const SightEnd from = any_end(p, b.cycles), to = any_end(p, b.cycles);
    const Slot aside = any_slot(p);
    RC_ASSERT(sights(p, from, to) == sights(p, to, from));
    RC_ASSERT(sights(p, from, to, {aside}) == sights(p, to, from, {aside}));
  });
}

TEST(SightsLaws, LeavingEdgesAsideLosesNoSight) {
  expect_law("sights (2)", 2000, [] {
    EdgeIds ids;
    const Boundary b = *polygons();
    const Polygon p = make(b.cycles, ids);
    const SightEnd from = any_end(p, b.cycles), to = any_end(p, b.cycles);
    if (sights(p, from, to)) RC_ASSERT(sights(p, from, to, {any_slot(p)}));
  });
}

TEST(SightsLaws, WhatIsSightedIsSoFromAllBetween) {
  expect_law("sights (3)", 3000, [] {
    EdgeIds ids;
    const Boundary b = *polygons();
    const Polygon p = make(b.cycles, ids);
    const SightEnd from = any_end(p, b.cycles);
    const Point2 step = small_point(9), between = from.at + static_cast<double>(whole(1, 5)) * step,
                 to = between + static_cast<double>(whole(1, 5)) * step;
    if (sights(p, from, {to})) {
      RC_ASSERT(sights(p, from, {between}));
      RC_ASSERT(sights(p, {between}, {to}));
    }
  });
}

TEST(SightsLaws, EndsOfAnEdgeDoNotSightEachOther) {
  expect_law("sights (4)", 1500, [] {
    EdgeIds ids;
    const Polygon p = make((*polygons()).cycles, ids);
    const Slot s = any_slot(p), t = p.next(s);
    RC_ASSERT(!sights(p, {p.at(s), s}, {p.at(t), t}));
    RC_ASSERT(sights(p, {p.at(s), s}, {p.at(s), s}));
  });
}

TEST(SightsLaws, MotionsAndMirrorKeepIt) {
  expect_law("sights (5)", 2000, [] {
    EdgeIds ids;
    const Boundary b = *polygons();
    const shapes::Map m = any_motion();
    const Polygon p = make(b.cycles, ids), q = make(shapes::mapped(b.cycles, m), ids);
    const SightEnd from = any_end(p, b.cycles), to = any_end(p, b.cycles);
    RC_ASSERT(sights(p, from, to) == sights(q, {m(from.at), from.vertex}, {m(to.at), to.vertex}));
  });
}

// nearest_perimeter_point and nearest_fraction

TEST(NearestFractionLaws, ItIsAFractionAndMotionsKeepItExactly) {
  expect_law("nearest_fraction (1) (2)", 4000, [] {
    const auto [at] = *grid_points<3>();
    const auto [a, b, p] = at;
    const double t = nearest_fraction(a, b, p);
    const shapes::Map m = any_motion();
    RC_ASSERT(0 <= t && t <= 1);
    RC_ASSERT(nearest_fraction(a, b, a) == 0);
    RC_ASSERT(nearest_fraction(a, b, b) == (a == b ? 0 : 1));
    RC_ASSERT(nearest_fraction(m(a), m(b), m(p)) == t);
  });
}

TEST(NearestPerimeterPointLaws, NoOtherEdgeIsNearer) {
  expect_law("nearest_perimeter_point (1)", 2000, [] {
    EdgeIds ids;
    const Boundary b = *polygons();
    const Polygon p = make(b.cycles, ids);
    const Point2 q = properties::telling_point(b.cycles, 20);
    const auto within = static_cast<double>(whole(1, 60));
    const auto found = nearest_perimeter_point(p, q, within);
    const double distance = distance_to(p, q), rounding = 1e-9 * (1 + std::abs(q.x) + std::abs(q.y));
    if (found) {
      RC_ASSERT(found->squared_distance < within * within);
      RC_ASSERT(std::sqrt(found->squared_distance) <= distance + rounding);
    } else {
      RC_ASSERT(distance + rounding >= within);
    }
  });
}

TEST(NearestPerimeterPointLaws, QuarterTurnsKeepItExactly) {
  expect_law("nearest_perimeter_point (2)", 3000, [] {
    EdgeIds ids, others;
    const Boundary b = *polygons();
    const shapes::Map m = shapes::kQuarterTurn;
    const Polygon p = make(b.cycles, ids), r = make(shapes::mapped(b.cycles, m), others);
    const Point2 q = properties::telling_point(b.cycles, 20);
    const auto within = static_cast<double>(whole(1, 60));
    const auto found = nearest_perimeter_point(p, q, within);
    const auto turned = nearest_perimeter_point(r, m(q), within);
    RC_ASSERT(found.has_value() == turned.has_value());
    if (!found) return;
    RC_ASSERT(found->edge == turned->edge);
    RC_ASSERT(found->fraction == turned->fraction);
    RC_ASSERT(m(found->at) == turned->at);
    RC_ASSERT(found->squared_distance == turned->squared_distance);
  });
}

TEST(NearestPerimeterPointLaws, FartherSearchesFindTheSamePoint) {
  expect_law("nearest_perimeter_point (3), any_edge_within (1)", 2000, [] {
    EdgeIds ids;
    const Boundary b = *polygons();
    const Polygon p = make(b.cycles, ids);
    const Point2 q = properties::telling_point(b.cycles, 20), r = properties::telling_point(b.cycles, 5);
    const auto within = static_cast<double>(whole(1, 60));
    const double more = within + static_cast<double>(whole(0, 60));
    const auto found = nearest_perimeter_point(p, q, within), again = nearest_perimeter_point(p, q, more);
    if (found) RC_ASSERT(again && again->edge == found->edge && again->fraction == found->fraction);
    if (any_edge_within(p, q, r, within)) RC_ASSERT(any_edge_within(p, q, r, more));
  });
}

}  // namespace
}  // namespace limpet::geometry
