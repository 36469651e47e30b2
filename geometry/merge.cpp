// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/geometry/merge.hpp>

#include <limpet/geometry/bridge.hpp>
#include <limpet/geometry/predicates.hpp>
#include <limpet/geometry/search.hpp>
#include <limpet/geometry/unite.hpp>

namespace limpet::geometry {
namespace {

bool perimeters_meet(const Polygon& a, const Polygon& b) {
  for (std::uint32_t i = 0; i < b.slot_count(); ++i) {
    const Slot s{i};
    if (!b.alive(s)) continue;
    const Point2 p = b.at(s), q = b.end(s);
    if (a.any_edge_near(box_of(p, q), [&](Slot t) { return segments_meet(p, q, a.at(t), a.end(t)); }))
      return true;
  }
  return false;
}

bool any_vertex_inside(const Polygon& vertices_of, const Polygon& polygon) {
  for (const auto& c : vertices_of.cycles())  // perimeters are disjoint: one vertex of each cycle is enough
    if (c.size > 0 && polygon.locate(vertices_of.at(c.first)) == Polygon::Side::inside) return true;
  return false;
}

bool within_gap(const Polygon& a, const Polygon& b, const Gap& gap) {
  for (std::uint32_t i = 0; i < b.slot_count(); ++i)
    if (b.alive(Slot{i}) && nearest_perimeter_point(a, b.at(Slot{i}), gap.at(b.at(Slot{i})))) return true;
  const Box2 around = b.box().grown(gap.most());
  return a.any_edge_near(around, [&](Slot s) {
    return around.contains(a.at(s)) && nearest_perimeter_point(b, a.at(s), gap.at(a.at(s))).has_value();
  });
}

bool no_edge_in(const Polygon& polygon, const Box2& box) {
  return !polygon.any_edge_near(box, [](Slot) { return true; });
}

constexpr double kNeedleWidth = 8;

/// Does the vertex end a needle, a spike less than eight grid steps wide?
bool ends_needle(const Polygon& a, Slot s) {
  const Point2 tip = a.at(s), before = a.at(a.prev(s)) - tip, after = a.end(s) - tip;
  const double longer2 = std::max(squared_length(before), squared_length(after));
  const double width = cross(before, after);  // times the longer side
  return dot(before, after) > 0 && width * width < kNeedleWidth * kNeedleWidth * longer2;
}

/// Tips of needles of a that b comes near to. Where b's perimeter crosses a needle, rounding can make the
/// union meet itself.
std::vector<std::pair<Slot, EdgeId>> needles(const Polygon& a, const Polygon& b) {
  std::vector<std::pair<Slot, EdgeId>> found;
  a.any_edge_near(b.box().grown(kNeedleWidth), [&](Slot s) {
    if (a.node(s).shared || a.node(a.prev(s)).shared) return false;
    if (ends_needle(a, s) && any_edge_within(b, a.at(a.prev(s)), a.at(s), kNeedleWidth))
      found.emplace_back(s, a.node(s).edge);
    return false;
  });
  std::sort(found.begin(), found.end(), [](const auto& p, const auto& q) { return p.second < q.second; });
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

bool take_away(Polygon& a, const std::vector<std::pair<Slot, EdgeId>>& tips, EdgeIds& ids) {
  bool any = false;
  for (const auto& [s, edge] : tips) {
    // Checked again, because removing the previous needle may have changed this one.
    if (!a.alive(s) || a.node(s).edge != edge || !ends_needle(a, s)) continue;
    Edit edit;
    edit.chains.push_back({a.prev(s), {}, a.next(s)});
    any |= a.change(edit, ids) == Verdict::valid;
  }
  return any;
}

Merger merge_as_they_are(Polygon& a, const Polygon& b, const Gap& gap, EdgeIds& ids) {
  if (!a.box().grown(gap.most()).meets(b.box())) return Merger::too_far;
  if (no_edge_in(a, b.box())) {
    if (a.locate(b.at(b.outer().first)) == Polygon::Side::inside) return Merger::contained;
  } else if (perimeters_meet(a, b) || any_vertex_inside(b, a) || any_vertex_inside(a, b)) {
    return unite(a, b, gap, ids) ? Merger::united : Merger::refused;
  }
  if (bridge_polygons(a, b, gap, ids)) return Merger::bridged;
  return within_gap(a, b, gap) ? Merger::refused : Merger::too_far;
}

}  // namespace

Merger merge_polygons(Polygon& a, const Polygon& b, const Gap& gap, EdgeIds& ids) {
  const Merger merger = merge_as_they_are(a, b, gap, ids);
  if (merger != Merger::refused) return merger;
  const auto tips = needles(a, b);
  if (tips.empty()) return merger;
  Polygon trimmed = a;
  if (!take_away(trimmed, tips, ids)) return merger;
  const Merger second = merge_as_they_are(trimmed, b, gap, ids);
  if (second != Merger::united && second != Merger::bridged) return merger;
  a = std::move(trimmed);
  return second;
}

}  // namespace limpet::geometry
