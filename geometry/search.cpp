// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/geometry/search.hpp>

#include <limpet/geometry/judge.hpp>
#include <limpet/geometry/predicates.hpp>

namespace limpet::geometry {

std::optional<PerimeterPoint> nearest_perimeter_point(const Polygon& polygon, Point2 p, double within,
                                                      std::optional<CycleId> cycle) {
  std::optional<PerimeterPoint> best;
  const double limit = within * within;
  polygon.any_edge_near(Box2{p, p}.grown(within), [&](Slot s) {
    if (cycle && polygon.node(s).cycle != *cycle) return false;
    const Point2 a = polygon.at(s), b = polygon.end(s);
    const double box_d2 = box_of(a, b).squared_distance(p);
    if (best && box_d2 > best->squared_distance) return false;
    const double t = nearest_fraction(a, b, p);
    const Point2 at = a + t * (b - a);
    // Never below the box's, by rounding: the same edge is best in whatever order they come.
    const double d2 = std::max(squared_length(at - p), box_d2);
    if (d2 >= limit) return false;
    if (best && (d2 > best->squared_distance ||
                 (d2 == best->squared_distance && !(polygon.node(s).edge < polygon.node(best->edge).edge))))
      return false;
    best = PerimeterPoint{s, t, at, d2};
    return false;
  });
  return best;
}

bool any_edge_within(const Polygon& polygon, Point2 a, Point2 b, double within) {
  const auto squared_distance = [](Point2 p, Point2 c, Point2 d) {
    return squared_length(c + nearest_fraction(c, d, p) * (d - c) - p);
  };
  const double limit = within * within;
  return polygon.any_edge_near(box_of(a, b).grown(within), [&](Slot s) {
    const Point2 c = polygon.at(s), d = polygon.end(s);
    return squared_distance(a, c, d) < limit || squared_distance(b, c, d) < limit ||
           squared_distance(c, a, b) < limit || squared_distance(d, a, b) < limit ||
           segments_meet(a, b, c, d);
  });
}

bool sights(const Polygon& polygon, SightEnd p, SightEnd q, std::initializer_list<Slot> ignored) {
  if (p.at == q.at) return true;
  const std::uint64_t none = std::uint64_t{1} << 40;  // keys beyond all slots
  const auto key = [&](const SightEnd& e, std::uint64_t other) {
    return e.vertex == kNoSlot ? other : static_cast<std::uint64_t>(e.vertex);
  };
  const KeyedEdge line{p.at, q.at, key(p, none), key(q, none + 1)};
  return !polygon.any_edge_near(box_of(p.at, q.at), [&](Slot s) {
    if (std::find(ignored.begin(), ignored.end(), s) != ignored.end()) return false;
    const KeyedEdge edge{polygon.at(s), polygon.end(s), static_cast<std::uint64_t>(s),
                         static_cast<std::uint64_t>(polygon.next(s))};
    return in_conflict(line, edge);
  });
}

}  // namespace limpet::geometry
