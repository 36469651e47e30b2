// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/geometry/fissure.hpp>
#include <limpet/geometry/fissure_internal.hpp>

#include "perimeters.hpp"

namespace limpet::geometry {
namespace {

using internal::FissureType;

constexpr double kFilledGap = 50;

struct Filled {
  std::size_t count = 0;
  Polygon result;
};
Filled filled(const Cycles& cycles, double gap = kFilledGap) {
  EdgeIds ids;
  Filled f;
  f.result = make(cycles, ids);
  const Polygon before = f.result;
  f.count = fill_fissures(f.result, all_edges(f.result), gap, ids);
  EXPECT_EQ(judge_polygon(f.result), Verdict::valid);
  if (f.count == 0) {
    EXPECT_TRUE(same_boundary(before, f.result));
  }
  expect_identities_hold(before, f.result);
  return f;
}

using Four = std::array<Point2, 4>;
constexpr Point2 kFar{-9999, -9999};

TEST(FindFissure, TypeOneJoinsTheEndsOfANotch) {
  const Four v = {{{200, 0}, {180, -500}, {160, 0}, kFar}};
  const auto f = find_fissure(FissureType::I, v, kFilledGap);
  ASSERT_TRUE(f.has_value());
  EXPECT_EQ(f->first, 0u);
  EXPECT_EQ(f->last, 2u);
  EXPECT_FALSE(f->foot.has_value());
  EXPECT_FALSE(find_fissure(FissureType::I, v, 40).has_value());  // not below the gap
  EXPECT_FALSE(find_fissure(FissureType::I, {{{160, 0}, {180, -500}, {200, 0}, kFar}},
                            kFilledGap));  // a point, no notch
  EXPECT_FALSE(
      find_fissure(FissureType::I, {{{160, 0}, {180, 0}, {200, 0}, kFar}}, kFilledGap));  // straight on
}

TEST(FindFissure, TypesTwoAndThreePutAFootOnTheLongerSide) {
  // The notch opens upwards; its right side ends low, its left side high.
  const auto two = find_fissure(FissureType::II, {{{120, 100}, {100, 0}, {100, 900}, kFar}}, kFilledGap);
  ASSERT_TRUE(two.has_value());
  EXPECT_EQ(*two->foot, (Point2{100, 100}));
  const auto three = find_fissure(FissureType::III, {{{100, 900}, {100, 0}, {80, 100}, kFar}}, kFilledGap);
  ASSERT_TRUE(three.has_value());
  EXPECT_EQ(*three->foot, (Point2{100, 100}));
  EXPECT_EQ(three->last, 2u);
  // 90 degrees and more is none.
  EXPECT_FALSE(find_fissure(FissureType::II, {{{120, 0}, {100, 0}, {100, 900}, kFar}}, kFilledGap));
}

TEST(FindFissure, TypesFourToSixHaveAShortFloor) {
  const auto four = find_fissure(FissureType::IV, {{{140, 500}, {140, 0}, {100, 0}, {100, 500}}}, kFilledGap);
  ASSERT_TRUE(four.has_value());
  EXPECT_EQ(four->last, 3u);
  EXPECT_FALSE(
      find_fissure(FissureType::IV, {{{150, 500}, {150, 0}, {100, 0}, {100, 500}}}, kFilledGap));  // floor
  const auto five = find_fissure(FissureType::V, {{{140, 100}, {140, 0}, {100, 0}, {100, 500}}}, kFilledGap);
  ASSERT_TRUE(five.has_value());
  EXPECT_EQ(*five->foot, (Point2{100, 100}));
  const auto six = find_fissure(FissureType::VI, {{{140, 500}, {140, 0}, {100, 0}, {100, 100}}}, kFilledGap);
  ASSERT_TRUE(six.has_value());
  EXPECT_EQ(*six->foot, (Point2{140, 100}));
}

TEST(FindFissure, OrderIsTheThesiss) {
  EXPECT_EQ(internal::kFissureOrder, (std::array{FissureType::IV, FissureType::V, FissureType::VI,
                                                 FissureType::I, FissureType::II, FissureType::III}));
}

/// A plate with this outline cut into its upper edge, from right to left.
Cycles plate(std::initializer_list<Point2> notch) {
  std::vector<NewVertex> cycle = cycle_of({{0, 0}, {1000, 0}, {1000, 1000}});
  for (const Point2 p : notch) cycle.push_back({p});
  cycle.push_back({{0, 1000}});
  return {cycle};
}

TEST(Fill, ANotch) {
  const Filled f = filled(plate({{520, 1000}, {500, 500}, {480, 1000}}));
  EXPECT_EQ(f.count, 1u);
  EXPECT_EQ(outline(f.result), outline(plate({{520, 1000}, {480, 1000}})));
}

TEST(Fill, ASlitWithAFloor) {
  const Filled f = filled(plate({{520, 1000}, {520, 500}, {480, 500}, {480, 1000}}));
  EXPECT_EQ(f.count, 1u);  // type IV comes first and takes all of it
  EXPECT_EQ(outline(f.result), outline(plate({{520, 1000}, {480, 1000}})));
}

TEST(Fill, AWideNotchStays) {
  const Filled f = filled(plate({{560, 1000}, {560, 500}, {440, 500}, {440, 1000}}));
  EXPECT_EQ(f.count, 0u);
}

TEST(Fill, OneSideOfTheSlitIsLonger) {
  const Cycles step = {
      cycle_of({{0, 0}, {1000, 0}, {1000, 800}, {540, 800}, {540, 500}, {500, 500}, {500, 1000}, {0, 1000}})};
  const Filled f = filled(step);  // type V
  EXPECT_EQ(
      outline(f.result),
      outline({cycle_of({{0, 0}, {1000, 0}, {1000, 800}, {540, 800}, {500, 800}, {500, 1000}, {0, 1000}})}));
}

TEST(Fill, ACascade) {
  // A slit in steps: each filling forms the next.
  const Filled f = filled(plate(
      {{524, 1000}, {520, 800}, {516, 600}, {512, 400}, {488, 400}, {484, 600}, {480, 800}, {476, 1000}}));
  EXPECT_GT(f.count, 1u);
  EXPECT_EQ(outline(f.result), outline(plate({{524, 1000}, {476, 1000}})));
}

/// A pocket beside an edge 10⁷ steps long: each foot on that edge is rounded, and the next one must not
/// follow it, or the edge turns inwards with it.
TEST(Fill, AFootDoesNotCreepAlongItsOwnRounding) {
  const Filled f = filled({cycle_of({{16753626, 5606214},
                                     {16741414, 5602142},
                                     {16742894, 5597700},
                                     {16750664, 5600291},
                                     {16753995, 5590302},
                                     {16745222, 5587380},
                                     {11163692, 22331962},
                                     {0, 0},
                                     {16759918, 5587340}})},
                          10000);
  EXPECT_GT(f.count, 0u);
  EXPECT_LT(f.count, 10u);
}

TEST(Fill, SharedEdgesStay) {
  for (int k = 3; k <= 5; ++k) {
    Cycles cycles = plate({{520, 1000}, {520, 500}, {480, 500}, {480, 1000}});
    cycles[0][static_cast<std::size_t>(k)].shared = true;
    EdgeIds ids;
    Polygon p = make(cycles, ids);
    const EdgeId edge = p.vertices(p.cycles()[0])[static_cast<std::size_t>(k)].edge;
    fill_fissures(p, all_edges(p), kFilledGap, ids);
    const auto removed = p.take_removed();
    EXPECT_EQ(std::count(removed.begin(), removed.end(), edge), 0);
  }
}

TEST(Fill, OnlyWhereEdgesAreFresh) {
  EdgeIds ids;
  Polygon p = make(plate({{520, 1000}, {500, 500}, {480, 1000}}), ids);
  const std::pair<Slot, EdgeId> bottom{Slot{0}, p.node(Slot{0}).edge};
  EXPECT_EQ(fill_fissures(p, std::span(&bottom, 1), kFilledGap, ids), 0u);
}

TEST(Fill, OnlyWhatMayBeFilled) {
  // Two notches, one on the left and one on the right; the right one may not be filled.
  const Cycles cycles = plate({{820, 1000}, {800, 500}, {780, 1000}, {220, 1000}, {200, 500}, {180, 1000}});
  const auto on_the_left = [](std::span<const Point2> region) {
    EXPECT_LT(chain_orientation(region), 0) << "clockwise";
    return std::all_of(region.begin(), region.end(), [](Point2 p) { return p.x < 500; });
  };
  EdgeIds ids;
  Polygon p = make(cycles, ids);
  EXPECT_GT(fill_fissures(p, all_edges(p), kFilledGap, ids, true, on_the_left), 0u);
  EXPECT_EQ(p.locate({200, 900}), Polygon::Side::inside);
  EXPECT_EQ(p.locate({800, 900}), Polygon::Side::outside);
  EXPECT_GT(fill_fissures(p, all_edges(p), kFilledGap, ids), 0u);
  EXPECT_EQ(p.locate({800, 900}), Polygon::Side::inside);
}

TEST(Fill, OnlyWhereTheGapIsWiderThanTheInlet) {
  // Three notches, 40 wide; the gap grows from left to right, from 0 to 100.
  const Cycles cycles = plate({{820, 1000},
                               {800, 500},
                               {780, 1000},
                               {520, 1000},
                               {500, 500},
                               {480, 1000},
                               {220, 1000},
                               {200, 500},
                               {180, 1000}});
  EdgeIds ids;
  Polygon p = make(cycles, ids);
  const Gap gap([](Point2 at) { return at.x / 10; }, 100);
  EXPECT_GT(fill_fissures(p, all_edges(p), gap, ids), 0u);
  EXPECT_EQ(judge_polygon(p), Verdict::valid);
  EXPECT_EQ(p.locate({200, 900}), Polygon::Side::outside);
  EXPECT_EQ(p.locate({500, 900}), Polygon::Side::inside);
  EXPECT_EQ(p.locate({800, 900}), Polygon::Side::inside);
}

TEST(Fill, AHoleCollapses) {
  const Filled f = filled({rectangle(0, 0, 1000, 1000), reversed(rectangle(480, 200, 520, 800))});
  EXPECT_GT(f.count, 0u);
  EXPECT_EQ(outline(f.result), outline({rectangle(0, 0, 1000, 1000)}));
}

TEST(Fill, AWideHoleStays) {
  EXPECT_EQ(filled({rectangle(0, 0, 1000, 1000), reversed(rectangle(200, 200, 800, 800))}).count, 0u);
}

TEST(Fill, ARingCloses) {
  const Filled f = filled({cycle_of({{0, 0},
                                     {600, 0},
                                     {600, 290},
                                     {500, 290},
                                     {500, 100},
                                     {100, 100},
                                     {100, 500},
                                     {500, 500},
                                     {500, 310},
                                     {600, 310},
                                     {600, 600},
                                     {0, 600}})});
  EXPECT_GT(f.count, 0u);
  EXPECT_EQ(f.result.hole_count(), 1u);
  EXPECT_EQ(f.result.locate({300, 300}), Polygon::Side::outside);
  EXPECT_EQ(f.result.locate({550, 300}), Polygon::Side::inside);
}

TEST(Collapses, NarrowHolesOnly) {
  const auto hole = [](double w, double h) { return points_of(reversed(rectangle(0, 0, w, h))); };
  EXPECT_TRUE(collapses(hole(40, 40), kFilledGap));
  EXPECT_TRUE(collapses(hole(40, 4000), kFilledGap));
  EXPECT_TRUE(collapses(hole(4000, 40), kFilledGap));
  EXPECT_FALSE(collapses(hole(60, 60), kFilledGap));
  EXPECT_FALSE(collapses(hole(4000, 60), kFilledGap));
  EXPECT_TRUE(collapses({{0, 0}, {20, 30}, {40, 0}}, kFilledGap));
  EXPECT_TRUE(collapses({}, kFilledGap));
}

TEST(Fill, AreaNeverDecreases) {
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    EdgeIds ids;
    const double scale = random.chance(0.5) ? 1 : random.scale(1, 1e5);
    Polygon p = random_polygon(random, ids, scale, random.scale(1, 1e9));
    const Polygon before = p;
    count += fill_fissures(p, all_edges(p), std::floor(random.scale(2, 30) * scale), ids);
    ASSERT_EQ(judge_polygon(p), Verdict::valid);
    ASSERT_GE(area(p), area(before) - 2 * perimeter(before));
    for (const auto& c : before.boundary())  // contained, up to the rounding of feet
      for (const NewVertex& v : c)
        if (p.locate(v.at) == Polygon::Side::outside) {
          ASSERT_LE(distance_to(p, v.at), 1.5);
        }
    expect_identities_hold(before, p);
    expect_index_holds(p, random, 5);
    if (HasFailure()) return;
  }
  EXPECT_GT(count, 1000u);
}

}  // namespace
}  // namespace limpet::geometry
