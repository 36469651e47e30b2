// Copyright the limpet authors. GPL-3.0-or-later.
//
// The numbered laws of operations on one perimeter: mend.hpp, extend.hpp, fissure.hpp.
#include <limpet/geometry/extend.hpp>
#include <limpet/geometry/fissure.hpp>
#include <limpet/geometry/mend.hpp>

#include "laws.hpp"

namespace limpet::geometry {
namespace {

// mend_cycles

TEST(MendLaws, ItLeavesNoConflictAndWhatHasNoneAlone) {
  expect_law("mend_cycles (1) (2)", 3000, [] {
    Cycles cycles = (*boundaries()).cycles;
    const Cycles before = cycles;
    const auto no_close = [](const auto& c) {
      for (std::size_t i = 0; i < c.size(); ++i)
        if (squared_length(c[(i + 1) % c.size()].at - c[i].at) < 4) return false;
      return true;
    };
    const bool good = std::all_of(before.begin(), before.end(), no_close) && whole_numbers::is_simple(before);
    const bool mended = mend_cycles(cycles, 1e9);
    if (mended) RC_ASSERT(whole_numbers::is_simple(cycles));
    if (good) RC_ASSERT(mended && outline(cycles) == outline(before));
  });
}

TEST(MendLaws, MotionsKeepIt) {
  expect_law("mend_cycles (3)", 2000, [] {
    Cycles cycles = (*boundaries()).cycles;
    const shapes::Map m = any_motion(20);
    Cycles moved = shapes::mapped(cycles, m);
    const auto area = static_cast<double>(whole(0, 1000));
    const bool mended = mend_cycles(cycles, area);
    RC_ASSERT(mend_cycles(moved, area) == mended);
    RC_ASSERT(outline(moved) == outline(shapes::mapped(cycles, m)));
  });
}

TEST(MendLaws, NoMoreAreaChangesThanItMay) {
  std::size_t refused = 0, mended = 0;
  expect_law("mend_cycles (4)", 3000, [&] {
    Cycles before = (*boundaries()).cycles;
    for (auto& cycle : before) {
      for (NewVertex& v : cycle) v.at = 2 * v.at;  // so that only vertices in the same place are close
    }
    Cycles cycles = before, freely = before;
    const auto area = static_cast<double>(whole(0, 100));
    if (!mend_cycles(cycles, area)) {
      ++refused;
      return;
    }
    ++mended;
    RC_ASSERT(std::abs(exact_area(cycles) - exact_area(before)) <= area);
    RC_ASSERT(mend_cycles(freely, 1e9));
    RC_ASSERT(outline(freely) == outline(cycles));
  });
  EXPECT_TRUE(refused > 0 && mended > 0);
}

// restore_sides

TEST(RestoreSidesLaws, VerticesMoveByTwoStepsAtMostAndOnlyWhereEdgesConflict) {
  expect_law("restore_sides (1) (2)", 3000, [] {
    const Cycles before = (*polygons()).cycles;
    Cycles moved = before;
    for (auto& c : moved)
      for (NewVertex& v : c)
        if (one_of(3) == 2) v.at = v.at + small_point(1);
    Cycles restored = moved;
    const bool conflicts = !whole_numbers::is_simple(moved);
    const bool done = restore_sides(restored, before);
    if (done) RC_ASSERT(whole_numbers::is_simple(restored));
    if (!done || !conflicts) RC_ASSERT(outline(restored) == outline(moved));
    for (std::size_t c = 0; c < moved.size(); ++c)
      for (std::size_t i = 0; i < moved[c].size(); ++i) {
        const Point2 d = restored[c][i].at - moved[c][i].at;
        RC_ASSERT(std::abs(d.x) <= 2 && std::abs(d.y) <= 2);
      }
  });
}

// extend_to_point

std::vector<NewVertex> vertices_new_in(const Polygon& after, const Polygon& before) {
  const auto all = [](const Polygon& p) {
    std::vector<NewVertex> vertices;
    for (const auto& cycle : p.boundary()) vertices.insert(vertices.end(), cycle.begin(), cycle.end());
    return vertices;
  };
  std::vector<NewVertex> vertices = all(after);
  const auto old = all(before);
  std::erase_if(vertices, [&](const NewVertex& v) {
    return std::any_of(old.begin(), old.end(), [&](const NewVertex& w) { return w.at == v.at; });
  });
  return vertices;
}

TEST(ExtendLaws, WhatIsNotExtendedIsAsItWasAndWhatIsHoldsThePointAndItsArea) {
  expect_law("extend_to_point (1) (2) (3) (4)", Cases{3000, 0.2}, [] {
    EdgeIds ids;
    const Boundary b = *polygons();
    Polygon p = make(b.cycles, ids);
    const auto shared = share_some(p);
    const Polygon before = p;
    const double gap = any_gap();
    const Point2 q = properties::telling_point(b.cycles, 40);
    const bool outside = whole_numbers::locate(b.cycles, q) < 0;
    RC_LOG() << q << " gap " << gap << "\n";
    const Extension extension = extend_to_point(p, q, gap, ids);
    RC_ASSERT((extension == Extension::contained) == !outside);
    RC_ASSERT(holds_shared(p, shared));
    RC_CLASSIFY(extension == Extension::extended);
    if (extension != Extension::extended) {
      RC_ASSERT(same_boundary(before, p));
      return;
    }
    expect_valid(p);
    RC_ASSERT(whole_numbers::locate(p.boundary(), q) == 0);
    RC_ASSERT(exact_area(p.boundary()) >= exact_area(b.cycles) - perimeter(before));
    for (const NewVertex& v : vertices_new_in(p, before))
      RC_ASSERT(squared_length(v.at - q) <= (gap + 1) * (gap + 1));
    RC_ASSERT(adds_no_more_than(p, {&before}, gap + 2));
    RC_ASSERT(exact_area(p.boundary()) <=
              exact_area(b.cycles) + M_PI * (gap + 1) * (gap + 1) + perimeter(before));
    RC_ASSERT(extend_to_point(p, q, gap, ids) == Extension::contained);
  });
}

// fill_fissures

TEST(FillLaws, ItKeepsThePolygonValidItsSharedEdgesAndItsArea) {
  expect_law("fill_fissures (1) (2) (3) (4)", Cases{2500, 0.2}, [] {
    EdgeIds ids;
    const Boundary b = *polygons();
    Polygon p = make(b.cycles, ids);
    const auto shared = share_some(p);
    const Polygon before = p;
    const double gap = any_gap();
    RC_LOG() << "gap " << gap << "\n";
    const std::size_t filled = fill_fissures(p, all_edges(p), gap, ids);
    if (filled == 0) RC_ASSERT(same_boundary(before, p));
    expect_valid(p);
    RC_ASSERT(holds_shared(p, shared));
    RC_ASSERT(exact_area(p.boundary()) >= exact_area(b.cycles) - 2 * perimeter(before));
    RC_ASSERT(adds_no_more_than(p, {&before}, gap + 2));
    RC_CLASSIFY(filled > 0);
  });
}

}  // namespace
}  // namespace limpet::geometry
