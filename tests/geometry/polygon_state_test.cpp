// Copyright the limpet authors. GPL-3.0-or-later.
//
// A polygon that was taken apart and put together again goes on as the one that was not.
#include <functional>
#include <limits>
#include <stdexcept>

#include <limpet/geometry/extend.hpp>
#include <limpet/geometry/fissure.hpp>
#include <limpet/geometry/merge.hpp>

#include "perimeters.hpp"

namespace limpet::geometry {
namespace {

bool same_bits(const Polygon& a, const Polygon& b) {
  const PolygonState p = a.state(), q = b.state();
  const auto node = [](const Polygon::Node& n, const Polygon::Node& m) {
    return n.at == m.at && n.next == m.next && n.prev == m.prev && n.cycle == m.cycle && n.edge == m.edge &&
           n.shared == m.shared;
  };
  const auto cycle = [](const Polygon::Cycle& c, const Polygon::Cycle& d) {
    return c.first == d.first && c.size == d.size && c.hole == d.hole;
  };
  return std::equal(p.nodes.begin(), p.nodes.end(), q.nodes.begin(), q.nodes.end(), node) &&
         std::equal(p.cycles.begin(), p.cycles.end(), q.cycles.begin(), q.cycles.end(), cycle) &&
         p.free == q.free && p.origin == q.origin && p.twice_area == q.twice_area && p.box.low == q.box.low &&
         p.box.high == q.box.high && p.index_edges == q.index_edges && p.removed == q.removed &&
         p.created == q.created && p.version == q.version && p.joins == q.joins;
}

/// Points are added all around, fissures filled, other polygons merged in; the twin is put away now and then.
TEST(PolygonState, IsGoneOnFromToTheBit) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    EdgeIds ids, ids_too;
    constexpr double kGap = 40;
    Polygon kept = random_polygon(random, ids, 20);
    ids_too = ids;
    Polygon twin = Polygon::from_state(kept.state());
    for (int step = 0; step < 60; ++step) {
      const Point2 q = telling_point(random, kept, 35);
      const int kind = static_cast<int>(random.whole(0, 9));
      if (kind == 0) {
        const auto fresh = kept.take_created();
        ASSERT_EQ(fresh, twin.take_created());
        ASSERT_EQ(fill_fissures(kept, fresh, kGap, ids), fill_fissures(twin, fresh, kGap, ids_too));
      } else if (kind == 1) {
        EdgeIds other_ids(1'000'000 + 1'000 * static_cast<std::uint64_t>(step));
        const Cycles cycles{rectangle(q.x, q.y, q.x + 30, q.y + 20)};
        const auto other = Polygon::from_cycles(cycles, other_ids);
        ASSERT_EQ(merge_polygons(kept, *other, kGap, ids), merge_polygons(twin, *other, kGap, ids_too));
      } else {
        ASSERT_EQ(extend_to_point(kept, q, kGap, ids), extend_to_point(twin, q, kGap, ids_too));
      }
      ASSERT_TRUE(same_bits(kept, twin)) << "seed " << seed << " step " << step;
      ASSERT_EQ(ids.next(), ids_too.next()) << "seed " << seed << " step " << step;
      if (random.chance(0.2)) twin = Polygon::from_state(twin.state());
    }
    expect_index_holds(twin, random, 20);
  }
}

TEST(PolygonState, IsRefusedWhenItDoesNotFitTogether) {
  EdgeIds ids;
  const Polygon polygon = make({rectangle(0, 0, 100, 100), reversed(rectangle(20, 20, 40, 40))}, ids);
  const std::vector<std::function<void(PolygonState&)>> damages = {
      [](auto& p) { p.nodes[1].next = Slot{77}; },
      [](auto& p) { p.nodes[1].next = kNoSlot; },
      [](auto& p) { p.nodes[1].prev = Slot{2}; },
      [](auto& p) { p.nodes[1].cycle = CycleId{1}; },
      [](auto& p) { p.nodes[1].cycle = CycleId{9}; },
      [](auto& p) { p.nodes[1].edge = {}; },
      [](auto& p) {
        p.nodes[1].at = {0.5, 0};
      },
      [](auto& p) {
        p.nodes[1].at = {std::numeric_limits<double>::quiet_NaN(), 0};
      },
      [](auto& p) {
        p.nodes[1].at = {1e300, 0};
      },
      [](auto& p) { p.nodes[1].at = p.nodes[0].at; },
      [](auto& p) {
        p.nodes[5].at = {-50, 50};
      },  // the hole crosses the outer perimeter
      [](auto& p) { p.cycles[0].size = 3; },
      [](auto& p) { p.cycles[0].size = 1u << 31; },
      [](auto& p) { p.cycles[0].first = Slot{4}; },
      [](auto& p) { p.cycles[0].hole = true; },
      [](auto& p) { p.cycles[1].hole = false; },
      [](auto& p) { p.cycles.clear(); },
      [](auto& p) { p.nodes.clear(); },
      [](auto& p) { p.free.push_back(1); },
      [](auto& p) { p.free.push_back(99); },
      [](auto& p) { p.nodes.emplace_back(); },
      [](auto& p) {
        p.box = {{0, 0}, {50, 50}};
      },
      [](auto& p) { p.twice_area = -1; },
      [](auto& p) { p.created.emplace_back(Slot{99}, EdgeId{1}); },
      [](auto& p) { p.index_edges = 30, p.index_box = p.box; },
      [](auto& p) { p.index_edges = std::uint64_t{1} << 60, p.index_box = p.box; },
  };
  for (std::size_t i = 0; i < damages.size(); ++i) {
    PolygonState state = polygon.state();
    damages[i](state);
    EXPECT_THROW(Polygon::from_state(std::move(state)), std::invalid_argument) << "damage " << i;
  }
  EXPECT_TRUE(same_bits(Polygon::from_state(polygon.state()), polygon));
}

/// What is nearest, and which contacts come first, must not depend on the order of the cells' edges.
TEST(PolygonState, ParallelEdgesAreBridgedAlike) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    EdgeIds ids;
    std::vector<NewVertex> comb{{{0, 0}}, {{1000, 0}}};
    for (int i = 12; i > 0; --i)
      for (const Point2 p :
           {Point2{80.0 * i, 200}, {80.0 * i - 30, 200}, {80.0 * i - 30, 100}, {80.0 * i - 80, 100}})
        comb.push_back({p});
    Cycles cycles{comb};
    if (judge_cycles(cycles) != Verdict::valid) cycles = {rectangle(0, 0, 1000, 100)};
    Polygon a = make(cycles, ids);
    for (int i = 0; i < 20; ++i)  // a history
      extend_to_point(a,
                      {static_cast<double>(random.whole(0, 1000)), -static_cast<double>(random.whole(1, 30))},
                      40, ids);
    Polygon twin = Polygon::from_state(a.state());
    EdgeIds ids_too = ids, other_ids(1'000'000);
    const auto b = Polygon::from_cycles(Cycles{rectangle(10, 210, 950, 300)}, other_ids);
    ASSERT_EQ(merge_polygons(a, *b, 40, ids), merge_polygons(twin, *b, 40, ids_too));
    ASSERT_TRUE(same_bits(a, twin)) << "seed " << seed;
  }
}

}  // namespace
}  // namespace limpet::geometry
