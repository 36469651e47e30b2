// Copyright the limpet authors. GPL-3.0-or-later.
//
// The numbered laws of operations on two perimeters: unite.hpp, bridge.hpp, merge.hpp.
#include <limpet/geometry/bridge.hpp>
#include <limpet/geometry/merge.hpp>
#include <limpet/geometry/unite.hpp>

#include "laws.hpp"

namespace limpet::geometry {
namespace {

/// Is every vertex of the boundary inside the polygon, on it, or within `slack` steps of it?
bool holds(const Polygon& p, const Cycles& cycles, double slack) {
  for (const auto& c : cycles)
    for (const NewVertex& v : c)
      if (p.locate(v.at) == Polygon::Side::outside && distance_to(p, v.at) > slack) return false;
  return true;
}

// unite

/// How far unite() may move a vertex of b along an axis: out of the way and aside, 32 steps and half as many.
double farthest_move(double gap) { return std::min(48.0, std::max(3.0, gap / 64 * 1.5 + 1)); }

TEST(UniteLaws, TheUnionIsValidAndHoldsBoth) {
  expect_law("unite (1) (2) (3) (6)", Cases{2500, 0.6}, [] {
    const Pair pair = *pairs();
    EdgeIds ids;
    Polygon a = make(pair.a.cycles, ids);
    const Polygon before = a, b = make(pair.b.cycles, ids);
    const double gap = any_gap();
    RC_LOG() << "gap " << gap << "\n";
    std::size_t attempts = 0;
    const bool done = unite(a, b, gap, ids, &attempts);
    RC_CLASSIFY(done);
    if (!done) {
      RC_ASSERT(same_boundary(before, a));
      return;
    }
    expect_valid(a);
    const double moved = attempts == 1 ? 0 : farthest_move(gap);
    RC_ASSERT(holds(a, pair.a.cycles, 3));
    RC_ASSERT(holds(a, pair.b.cycles, 3 + 1.5 * moved));
    const double slack = (3 + 2 * moved) * (perimeter(before) + perimeter(b));
    RC_ASSERT(exact_area(a.boundary()) >=
              std::max(exact_area(pair.a.cycles), exact_area(pair.b.cycles)) - slack);
    RC_ASSERT(adds_no_more_than(a, {&before, &b}, gap + 3 + 1.5 * moved));
  });
}

TEST(UniteLaws, WithItselfItStaysAsItIs) {
  expect_law("unite (4)", 1500, [] {
    EdgeIds ids;
    const Boundary whole_one = *polygons();
    Polygon a = make(whole_one.cycles, ids);
    const Polygon before = a, same = make(whole_one.cycles, ids);
    const double gap = any_gap();
    RC_ASSERT(unite(a, same, gap, ids));
    RC_ASSERT(same_boundary(before, a));
  });
}

TEST(UniteLaws, TheOrderShowsInTheAreaByNoMoreThanRounding) {
  expect_law("unite (5)", 1500, [] {
    const Pair pair = *pairs();
    EdgeIds ids;
    Polygon a = make(pair.a.cycles, ids), b = make(pair.b.cycles, ids);
    const Polygon first = a, second = b;
    std::size_t attempts_a = 0, attempts_b = 0;
    const bool ab = unite(a, second, 2, ids, &attempts_a), ba = unite(b, first, 2, ids, &attempts_b);
    RC_LOG() << ab << ba << " " << attempts_a << attempts_b << " " << shown(a) << shown(b) << "\n";
    if (!ab || !ba) return;
    const double slack = 12 * (perimeter(first) + perimeter(second)) + 64;
    RC_ASSERT(std::abs(exact_area(a.boundary()) - exact_area(b.boundary())) <= slack);
  });
}

// bridge_polygons and bridge_self

TEST(BridgeLaws, WhatIsBridgedIsValidAndLosesNoArea) {
  expect_law("bridge_polygons (1) (2) (3)", Cases{2500, 0.04}, [] {
    Pair pair = *pairs();
    EdgeIds ids;
    Polygon a = make(pair.a.cycles, ids);
    const Polygon before = a, b = make(pair.b.cycles, ids);
    const double gap = any_gap();
    RC_LOG() << "gap " << gap << "\n";
    const bool overlap = [&] {
      for (const auto& [p, q] : edges_of(before))
        for (const auto& [r, s] : edges_of(b))
          if (whole_numbers::meet(p, q, r, s)) return true;
      return whole_numbers::locate(pair.a.cycles, pair.b.cycles[0][0].at) > 0 ||
             whole_numbers::locate(pair.b.cycles, pair.a.cycles[0][0].at) > 0;
    }();
    if (overlap) return;
    const bool done = bridge_polygons(a, b, gap, ids);
    RC_CLASSIFY(done);
    if (!done) {
      RC_ASSERT(same_boundary(before, a));
      return;
    }
    expect_valid(a);
    RC_ASSERT(exact_area(a.boundary()) >=
              exact_area(pair.a.cycles) + exact_area(pair.b.cycles) - 2 * (perimeter(before) + perimeter(b)));
    RC_ASSERT(adds_no_more_than(a, {&before, &b}, gap + 2));
  });
}

TEST(BridgeLaws, ASelfBridgeMakesAHoleAndKeepsSharedEdges) {
  expect_law("bridge_self (1) (2)", Cases{8000, 0.01}, [] {
    EdgeIds ids;
    const Boundary b = *polygons();
    Polygon p = make(b.cycles, ids);
    const auto shared = share_some(p);
    const Polygon before = p;
    const double gap = any_gap();
    RC_LOG() << "gap " << gap << "\n";
    bool done = false;
    for (const auto& [slot, edge] : all_edges(before)) {
      if ((done = bridge_self(p, slot, gap, ids))) break;
      RC_ASSERT(same_boundary(before, p));
    }
    RC_CLASSIFY(done);
    expect_valid(p);
    RC_ASSERT(holds_shared(p, shared));
    if (done) RC_ASSERT(p.hole_count() == before.hole_count() + 1);
  });
}

// merge_polygons

TEST(MergeLaws, OnlyUnionsAndBridgesChangeAnything) {
  expect_law("merge_polygons (1) (2) (3) (4)", Cases{2500, 0.6}, [] {
    const Pair pair = *pairs();
    EdgeIds ids;
    Polygon a = make(pair.a.cycles, ids), other = make(pair.b.cycles, ids);
    const Polygon before = a, b = other;
    const double gap = any_gap();
    RC_LOG() << "gap " << gap << "\n";
    const Merger merger = merge_polygons(a, b, gap, ids);
    const Merger swapped = merge_polygons(other, before, gap, ids);
    RC_CLASSIFY(merger == Merger::united || merger == Merger::bridged);
    RC_ASSERT((merger == Merger::too_far) == (swapped == Merger::too_far));
    if (merger != Merger::united && merger != Merger::bridged) {
      RC_ASSERT(same_boundary(before, a));
      return;
    }
    expect_valid(a);
    // Needles narrower than eight steps may have been taken away first.
    const double slack = (11 + 2 * farthest_move(gap)) * (perimeter(before) + perimeter(b));
    RC_ASSERT(exact_area(a.boundary()) >=
              std::max(exact_area(pair.a.cycles), exact_area(pair.b.cycles)) - slack);
    RC_ASSERT(adds_no_more_than(a, {&before, &b}, gap + 3 + 1.5 * farthest_move(gap)));
  });
}

}  // namespace
}  // namespace limpet::geometry
