// Copyright the limpet authors. GPL-3.0-or-later.
//
// The numbered laws of predicates.hpp, and that the stages of orientation() agree.
#include "../../geometry/predicates_internal.hpp"
#include "laws.hpp"

namespace limpet::geometry {
namespace {

Point2 minus(Point2 p) { return {-p.x, -p.y}; }

// orientation

TEST(OrientationLaws, RotatingTheArgumentsKeepsItAndSwappingTwoFlipsIt) {
  expect_law("orientation (1) (2)", 4000, [] {
    const auto p = *points_of_all_sizes<3>();
    const int o = orientation(p[0], p[1], p[2]);
    RC_ASSERT(orientation(p[1], p[2], p[0]) == o);
    RC_ASSERT(orientation(p[2], p[0], p[1]) == o);
    RC_ASSERT(orientation(p[1], p[0], p[2]) == -o);
    RC_ASSERT(orientation(p[0], p[2], p[1]) == -o);
  });
}

TEST(OrientationLaws, ItIsZeroWhenTwoArgumentsAreEqual) {
  expect_law("orientation (3)", 1000, [] {
    const auto p = *points_of_all_sizes<2>();
    RC_ASSERT(orientation(p[0], p[0], p[1]) == 0);
    RC_ASSERT(orientation(p[0], p[1], p[0]) == 0);
    RC_ASSERT(orientation(p[1], p[0], p[0]) == 0);
  });
}

TEST(OrientationLaws, MotionsOfTheGridKeepItAndTheMirrorFlipsIt) {
  expect_law("orientation (4)", 4000, [] {
    const auto p = *grid_points<3>();
    const shapes::Map m = any_motion(49), f = shapes::kMirror;
    const int o = orientation(p[0], p[1], p[2]);
    RC_ASSERT(orientation(m(p[0]), m(p[1]), m(p[2])) == o);
    RC_ASSERT(orientation(f(p[0]), f(p[1]), f(p[2])) == -o);
  });
}

TEST(OrientationLaws, LeftOfAllSidesMakesATriangleAnticlockwise) {
  expect_law("orientation (5)", 4000, [] {
    const auto [at] = *grid_points<4>();
    const auto [p, q, r, t] = at;
    if (orientation(t, q, r) > 0 && orientation(p, t, r) > 0 && orientation(p, q, t) > 0)
      RC_ASSERT(orientation(p, q, r) > 0);
  });
}

TEST(OrientationLaws, LeftnessIsTransitiveInAHalfPlane) {
  expect_law("orientation (6)", 8000, [] {
    const auto [at] = *grid_points<5>();
    const auto [s, t, p, q, r] = at;
    const bool half_plane = orientation(s, t, p) > 0 && orientation(s, t, q) > 0 && orientation(s, t, r) > 0;
    if (half_plane && orientation(s, p, q) >= 0 && orientation(s, q, r) >= 0)
      RC_ASSERT(orientation(s, p, r) == std::max(orientation(s, p, q), orientation(s, q, r)));
  });
}

TEST(OrientationLaws, CollinearityIsTransitive) {
  expect_law("orientation (7)", 4000, [] {
    const auto [at] = *points_of_all_sizes<4>();
    const auto [p, q, r, s] = at;
    if (p != q && orientation(p, q, r) == 0 && orientation(p, q, s) == 0) {
      RC_ASSERT(orientation(p, r, s) == 0);
      RC_ASSERT(orientation(q, r, s) == 0);
    }
  });
}

TEST(OrientationLaws, ItIsTheSignOfTheDeterminantInWholeNumbers) {
  const auto agrees = [](const Points<3>& p) {
    RC_ASSERT(orientation(p[0], p[1], p[2]) == whole_numbers::turn(p[0], p[1], p[2]));
  };
  expect_law("orientation on the grid", 10000, [&] { agrees(*grid_points<3>()); });
  expect_law("orientation of any doubles", 5000, [&] { agrees(*points_of_all_sizes<3>()); });
}

// The stages of orientation

void expect_stages_agree(const Points<3>& p) {
  const int filter = internal::orientation_filter(p[0], p[1], p[2]),
            exact = internal::orientation_exact(p[0], p[1], p[2]);
  RC_ASSERT(filter == 0 || filter == exact);
  RC_ASSERT(internal::orientation_unfiltered(p[0], p[1], p[2]) == exact);
  RC_ASSERT(whole_numbers::turn(p[0], p[1], p[2]) == exact);
  RC_CLASSIFY(filter == 0);
}

TEST(OrientationStages, AgreeOnTheGrid) {
  expect_law("stages on the grid", Cases{10000, 0.15}, [] { expect_stages_agree(*grid_points<3>()); });
}

TEST(OrientationStages, AgreeOnAnyDoublesThatUnderflowAndOverflowToo) {
  expect_law("stages on any doubles", Cases{5000, 0.4},
             [] { expect_stages_agree(*points_of_all_sizes<3>()); });
}

TEST(OrientationStages, TheFilterIsCertainOnTheGridUnlessZero) {
  expect_law("filter below 2^25 steps", 4000, [] {
    const auto p = *grid_points<3>();
    for (const Point2 q : p.at)
      if (std::abs(q.x) >= 0x1p25 || std::abs(q.y) >= 0x1p25) return;
    RC_ASSERT(internal::orientation_filter(p[0], p[1], p[2]) == whole_numbers::turn(p[0], p[1], p[2]));
  });
}

// segments_meet

TEST(SegmentsMeetLaws, ItIsSymmetricInTheSegmentsAndInTheirEnds) {
  expect_law("segments_meet (1)", 4000, [] {
    const auto [at] = *points_of_all_sizes<4>();
    const auto [a, b, c, d] = at;
    const bool meet = segments_meet(a, b, c, d);
    RC_ASSERT(segments_meet(c, d, a, b) == meet);
    RC_ASSERT(segments_meet(b, a, c, d) == meet);
    RC_ASSERT(segments_meet(a, b, d, c) == meet);
  });
}

TEST(SegmentsMeetLaws, SegmentsMeetThemselvesAndTheirEnds) {
  expect_law("segments_meet (2)", 1000, [] {
    const auto [at] = *points_of_all_sizes<3>();
    const auto [a, b, c] = at;
    RC_ASSERT(segments_meet(a, b, a, b));
    RC_ASSERT(segments_meet(a, b, b, c));
    RC_ASSERT(segments_meet(a, a, c, c) == (a == c));
  });
}

TEST(SegmentsMeetLaws, WhatMeetsASegmentMeetsOneOfItsParts) {
  expect_law("segments_meet (3)", 4000, [] {
    const auto [at] = *grid_points<4>();
    const auto [a, b, c, step] = at;
    const Point2 by{std::floor(step.x / 16), std::floor(step.y / 16)};
    const auto k = static_cast<double>(whole(0, 6)), n = static_cast<double>(whole(0, 6));
    const Point2 m = c + k * by, d = m + n * by;  // on one line, in this order
    RC_ASSERT(segments_meet(a, b, c, d) == (segments_meet(a, b, c, m) || segments_meet(a, b, m, d)));
  });
}

TEST(SegmentsMeetLaws, MotionsAndMirrorKeepIt) {
  expect_law("segments_meet (4)", 4000, [] {
    const auto p = *grid_points<4>();
    const bool meet = segments_meet(p[0], p[1], p[2], p[3]);
    for (const shapes::Map& m : {any_motion(49), shapes::kMirror})
      RC_ASSERT(segments_meet(m(p[0]), m(p[1]), m(p[2]), m(p[3])) == meet);
  });
}

TEST(SegmentsMeetLaws, ItIsWhatWholeNumbersSay) {
  const auto agrees = [](const Points<4>& p) {
    RC_ASSERT(segments_meet(p[0], p[1], p[2], p[3]) == whole_numbers::meet(p[0], p[1], p[2], p[3]));
  };
  expect_law("segments_meet on the grid", 8000, [&] { agrees(*grid_points<4>()); });
  expect_law("segments_meet of any doubles", 3000, [&] { agrees(*points_of_all_sizes<4>()); });
}

// edges_overlap

TEST(EdgesOverlapLaws, ItIsSymmetricAndTrueAtTheApex) {
  expect_law("edges_overlap (1) (2)", 3000, [] {
    const auto [at] = *points_of_all_sizes<3>();
    const auto [apex, p, q] = at;
    RC_ASSERT(edges_overlap(apex, p, q) == edges_overlap(apex, q, p));
    RC_ASSERT(edges_overlap(apex, apex, q));
    RC_ASSERT(edges_overlap(apex, p, p));
  });
}

TEST(EdgesOverlapLaws, ItIsTransitiveButForTheApex) {
  expect_law("edges_overlap (3)", 3000, [] {
    const auto [at] = *grid_points<4>();
    const auto [apex, p, q, r] = at;
    if (q != apex && edges_overlap(apex, p, q) && edges_overlap(apex, q, r))
      RC_ASSERT(edges_overlap(apex, p, r));
  });
}

TEST(EdgesOverlapLaws, OppositeEdgesDoNot) {
  expect_law("edges_overlap (4)", 3000, [] {
    const auto [at] = *grid_points<3>();
    const auto [apex, p, q] = at;
    if (p == apex || q == apex) return;
    const bool collinear = orientation(apex, p, q) == 0;
    const Point2 o{}, u = p - apex, v = q - apex;
    RC_ASSERT(edges_overlap(o, u, v) == edges_overlap(apex, p, q));
    RC_ASSERT(edges_overlap(o, u, v) + edges_overlap(o, u, minus(v)) == (collinear ? 1 : 0));
  });
}

TEST(EdgesOverlapLaws, MotionsAndMirrorKeepIt) {
  expect_law("edges_overlap (5)", 3000, [] {
    const auto p = *grid_points<3>();
    const bool overlap = edges_overlap(p[0], p[1], p[2]);
    for (const shapes::Map& m : {any_motion(49), shapes::kMirror})
      RC_ASSERT(edges_overlap(m(p[0]), m(p[1]), m(p[2])) == overlap);
  });
}

TEST(EdgesOverlapLaws, ItIsWhatWholeNumbersSay) {
  expect_law("edges_overlap in whole numbers", 4000, [] {
    const auto p = *points_of_all_sizes<3>();
    RC_ASSERT(edges_overlap(p[0], p[1], p[2]) == whole_numbers::overlap(p[0], p[1], p[2]));
  });
}

// chain_orientation

TEST(ChainOrientationLaws, NoStartIsSpecialAndReversalFlipsIt) {
  expect_law("chain_orientation (1) (2) (3) (4)", 1500, [] {
    const Boundary polygon = *polygons();
    for (const auto& cycle : polygon.cycles) {
      std::vector<Point2> chain;
      for (const NewVertex& v : cycle) chain.push_back(v.at);
      const auto area = whole_numbers::twice_area(cycle);
      const int sign = area > 0 ? 1 : -1;
      std::rotate(chain.begin(), chain.begin() + whole(0, 99) % std::ssize(chain), chain.end());
      RC_ASSERT(chain_orientation(chain) == sign);
      std::reverse(chain.begin(), chain.end());
      RC_ASSERT(chain_orientation(chain) == -sign);
      const shapes::Map m = any_motion(49);
      for (Point2& p : chain) p = m(p);
      RC_ASSERT(chain_orientation(chain) == -sign);
    }
  });
}

}  // namespace
}  // namespace limpet::geometry
