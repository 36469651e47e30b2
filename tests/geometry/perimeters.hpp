// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <limpet/geometry/judge.hpp>
#include <limpet/geometry/measure.hpp>
#include <limpet/geometry/polygon.hpp>
#include <limpet/geometry/predicates.hpp>

#include "perimeter_shapes.hpp"

namespace limpet::geometry {

using shapes::cycle_of;
using shapes::Cycles;
using shapes::Random;
using shapes::rectangle;
using shapes::reversed;

using EdgesInPlace = std::vector<std::pair<Slot, EdgeId>>;
inline EdgesInPlace all_edges(const Polygon& p) {
  EdgesInPlace edges;
  for (std::uint32_t i = 0; i < p.slot_count(); ++i)
    if (p.alive(Slot{i})) edges.emplace_back(Slot{i}, p.node(Slot{i}).edge);
  return edges;
}

inline Polygon make(const Cycles& cycles, EdgeIds& ids) {
  auto polygon = Polygon::from_cycles(cycles, ids);
  EXPECT_TRUE(polygon.has_value()) << to_string(judge_cycles(cycles));
  if (!polygon) polygon = Polygon::from_cycles(Cycles{rectangle(0, 0, 1, 1)}, ids);
  polygon->take_created();
  return *std::move(polygon);
}

/// A valid degenerate polygon in steps of `scale`, placed up to `place` steps away.
inline Polygon random_polygon(Random& random, EdgeIds& ids, double scale = 1, double place = 0) {
  for (;;) {
    Cycles cycles = shapes::raw_shape(random);
    shapes::map_all(cycles, shapes::random_map(random, scale, place));
    if (auto p = Polygon::from_cycles(cycles, ids)) {
      p->take_created();
      return *std::move(p);
    }
  }
}

inline std::vector<Point2> points_of(const std::vector<NewVertex>& cycle) {
  std::vector<Point2> points;
  for (const NewVertex& v : cycle) points.push_back(v.at);
  return points;
}

/// The points of all cycles, each turned to begin with its lowest point, for comparison with what is
/// expected.
inline std::vector<std::vector<std::pair<double, double>>> outline(const Cycles& cycles) {
  std::vector<std::vector<std::pair<double, double>>> result;
  for (const auto& cycle : cycles) {
    std::vector<std::pair<double, double>> points;
    for (const NewVertex& v : cycle) points.emplace_back(v.at.x, v.at.y);
    std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
    result.push_back(std::move(points));
  }
  if (result.size() > 1) std::sort(result.begin() + 1, result.end());
  return result;
}
inline auto outline(const Polygon& p) { return outline(p.boundary()); }

inline bool same_boundary(const Polygon& a, const Polygon& b) {
  return shapes::same(a.boundary(), b.boundary());
}

/// As text that can be put into a test.
inline std::string shown(const Polygon& p) {
  std::string text;
  for (const auto& c : p.boundary()) {
    text += text.empty() ? "{cycle_of({" : ", cycle_of({";
    for (const NewVertex& v : c)
      text += "{" + std::to_string(std::llround(v.at.x)) + "," + std::to_string(std::llround(v.at.y)) + "},";
    text += "})";
  }
  return text + "}";
}

inline std::vector<Segment2> edges_of(const Polygon& p) {
  std::vector<Segment2> edges;
  for (const auto& c : p.boundary())
    for (std::size_t i = 0; i < c.size(); ++i) edges.emplace_back(c[i].at, c[(i + 1) % c.size()].at);
  return edges;
}

inline double perimeter(const Polygon& p) {
  double length = 0;
  for (const auto& [a, b] : edges_of(p)) length += std::sqrt(squared_length(b - a));
  return length;
}

inline double distance_to(const Polygon& p, Point2 q) {
  double best = HUGE_VAL;
  for (const auto& [a, b] : edges_of(p)) {
    const double t = std::clamp(dot(q - a, b - a) / squared_length(b - a), 0.0, 1.0);
    best = std::min(best, std::sqrt(squared_length(a + t * (b - a) - q)));
  }
  return best;
}

/// Where p lies, by all edges.
inline Polygon::Side side_by_all_edges(const std::vector<Segment2>& edges, Point2 p) {
  for (const auto& [a, b] : edges)
    if (segments_meet(a, b, p, p)) return Polygon::Side::boundary;
  return inside_even_odd(edges, p) ? Polygon::Side::inside : Polygon::Side::outside;
}

/// A point at a vertex, on an edge's line, near an edge, or anywhere in the box.
inline Point2 telling_point(Random& random, const Polygon& p, double reach) {
  const auto edges = edges_of(p);
  const auto& [a, b] = edges[random.bits() % edges.size()];
  Point2 q = random.chance(0.3) ? a : a + (1.5 * random.unit() - 0.25) * (b - a);
  if (random.chance(0.2))
    q = {p.box().low.x + random.unit() * (p.box().high.x - p.box().low.x),
         p.box().low.y + random.unit() * (p.box().high.y - p.box().low.y)};
  if (random.chance(0.6)) q = q + reach * Point2{2 * random.unit() - 1, 2 * random.unit() - 1};
  return round_to_grid(q);
}

/// locate() and any_edge_near() against all edges.
inline void expect_index_holds(const Polygon& p, Random& random, int samples) {
  const auto edges = edges_of(p);
  for (int k = 0; k < samples; ++k) {
    const Point2 q = telling_point(random, p, 3);
    ASSERT_EQ(p.locate(q), side_by_all_edges(edges, q)) << q.x << " " << q.y;
    const Box2 box = Box2{q, q}.grown(static_cast<double>(random.whole(0, 20)));
    std::vector<EdgeId> found, wanted;
    p.any_edge_near(box, [&](Slot s) { return found.push_back(p.node(s).edge), false; });
    std::sort(found.begin(), found.end());
    for (std::uint32_t i = 0; i < p.slot_count(); ++i) {
      if (!p.alive(Slot{i})) continue;
      const Point2 a = p.at(Slot{i}), b = p.end(Slot{i});
      bool touches = box.contains(a) || box.contains(b);
      const Point2 corner[] = {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};
      for (int c = 0; c < 4; ++c) touches |= segments_meet(a, b, corner[c], corner[(c + 1) % 4]);
      if (touches) {
        ASSERT_TRUE(std::binary_search(found.begin(), found.end(), p.node(Slot{i}).edge)) << "edge missed";
      }
    }
  }
}

/// Identities are unique; of those there were before, each is still there or was logged as removed, once.
inline void expect_identities_hold(const Polygon& before, Polygon& after) {
  std::vector<EdgeId> old_ids, new_ids, removed = after.take_removed();
  for (const auto& c : before.boundary())
    for (const NewVertex& v : c) old_ids.push_back(v.edge);
  for (const auto& c : after.boundary())
    for (const NewVertex& v : c) new_ids.push_back(v.edge);
  for (auto* ids : {&old_ids, &new_ids, &removed}) {
    std::sort(ids->begin(), ids->end());
    ASSERT_EQ(std::adjacent_find(ids->begin(), ids->end()), ids->end()) << "identity there twice";
  }
  for (const EdgeId id : old_ids)
    ASSERT_NE(std::binary_search(new_ids.begin(), new_ids.end(), id),
              std::binary_search(removed.begin(), removed.end(), id))
        << "edge " << id.value;
}

}  // namespace limpet::geometry
