// Copyright the limpet authors. GPL-3.0-or-later.
//
// Merging two planar polygon segments (thesis §2.4.3).
#include <algorithm>
#include <cmath>

#include <limpet/geometry/merge.hpp>
#include <limpet/geometry/predicates.hpp>

#include "engine_internal.hpp"

namespace limpet::model::internal {
namespace {

bool within(const Box3& a, const Box3& b, double reach) {
  return a.squaredExteriorDistance(b) < reach * reach;
}

/// May the two be one plane, with a's published one until it is published anew? The smaller one's points are
/// judged about the larger one's plane.
bool planes_agree(const Engine& e, const Segment& a, const Segment& b) {
  const Segment& small = a.moments.count() < b.moments.count() ? a : b;
  const Segment& large = &small == &a ? b : a;
  double limit_rad = e.parameters.angle_rad;
  if (e.rules().residual) {
    const double ea = a.fit.normal_error(a.variance()), eb = b.fit.normal_error(b.variance());
    limit_rad = std::min(1.5, std::max(limit_rad, 3 * std::sqrt(ea * ea + eb * eb)));
  }
  const double cos_limit = limit_rad == e.parameters.angle_rad ? e.cos_angle : cosine(limit_rad);
  if (a.fit.normal.dot(b.fit.normal) <= cos_limit) return false;
  if (!faces_outside(a.polygon->outward, a.axis_sum + b.axis_sum)) return false;
  const double lambda2 = e.parameters.resolution * e.parameters.resolution;
  if (e.rules().residual) {
    const double residual2 = small.moments.squared_residual(large.fit.plane(), e.step);
    const double by_noise =
        4 * small.variance() + 9 * large.fit.height_variance(small.fit.centroid, large.variance());
    const double tolerance2 = e.parameters.tolerance * e.parameters.tolerance;
    if (residual2 > std::max(by_noise, tolerance2) || residual2 >= lambda2) return false;
    if (residual2 > by_noise && relief_kept(e) && !surfaces_continue(e, large, small)) return false;
  }
  Moments merged = a.moments;
  merged.add(b.moments);
  return variance_allowed(e, *a.polygon, merged) && fit_to(merged, e.step, -large.fit.normal).u3 < lambda2;
}

bool remembered_as_refused(const Engine& e, const Segment& a, const Segment& b) {
  const auto found = e.refused_pairs.find({std::min(a.id, b.id), std::max(a.id, b.id)});
  if (found == e.refused_pairs.end()) return false;
  const Segment &first = a.id < b.id ? a : b, &second = a.id < b.id ? b : a;
  return found->second == std::pair(first.polygon->shape, second.polygon->shape);
}

void remember_refusal(Engine& e, const Segment& a, const Segment& b) {
  const Segment &first = a.id < b.id ? a : b, &second = a.id < b.id ? b : a;
  e.refused_pairs[{first.id, second.id}] = {first.polygon->shape, second.polygon->shape};
  // Pairs with a segment that is gone go when there are many.
  if (e.refused_pairs.size() > 2 * e.slot_of.size() + 64)
    std::erase_if(e.refused_pairs, [&](const auto& entry) {
      return !e.find(entry.first.first) || !e.find(entry.first.second);
    });
}

/// Edges of b that did not come along into the merged perimeter.
std::vector<geometry::EdgeId> lost_edges(
    const geometry::Polygon& b, const std::vector<std::pair<geometry::Slot, geometry::EdgeId>>& created) {
  std::vector<geometry::EdgeId> ids, came;
  for (std::uint32_t i = 0; i < b.slot_count(); ++i)
    if (b.alive(geometry::Slot{i})) ids.push_back(b.node(geometry::Slot{i}).edge);
  for (const auto& [slot, edge] : created) came.push_back(edge);
  std::sort(ids.begin(), ids.end());
  std::sort(came.begin(), came.end());
  std::vector<geometry::EdgeId> lost;
  std::set_difference(ids.begin(), ids.end(), came.begin(), came.end(), std::back_inserter(lost));
  return lost;
}

/// Where a merger changes what others see: at the new edges, and all over what was young before.
Places changed_places(const Segment& a, const Segment& b,
                      const std::vector<std::pair<geometry::Slot, geometry::EdgeId>>& created) {
  Places places = places_of(*a.polygon, created);
  for (const Segment* s : {&a, &b})
    if (s->young()) places.add(s->polygon->box);
  return places;
}

/// With the thesis's rules a merger that leaves a hole fails.
geometry::Merger merge_perimeters(Engine& e, geometry::Polygon& a, const geometry::Polygon& b) {
  if (e.rules().holes) return geometry::merge_polygons(a, b, e.gap, e.edge_ids);
  geometry::Polygon trial = a;
  const auto merger = geometry::merge_polygons(trial, b, e.gap, e.edge_ids);
  if (trial.hole_count() > 0) return geometry::Merger::refused;
  a = std::move(trial);
  return merger;
}

/// All of b becomes a's, whose perimeter is already that of both; `other` was b's in a's chart. Returns where
/// the description has changed.
Places take_over(Engine& e, Segment& a, Segment& b, const geometry::Polygon& other,
                 std::vector<geometry::EdgeId>& inherited) {
  PolygonPart& part = *a.polygon;
  auto [removed, created] = boundary_changed(e, a);
  for (const auto& [slot, edge] : created)
    if (part.perimeter.alive(slot) && part.perimeter.node(slot).shared) inherited.push_back(edge);
  part.corners_due.insert(part.corners_due.end(), inherited.begin(), inherited.end());
  Places where = changed_places(a, b, created);
  for (const Box3& place : where.boxes()) part.box.extend(place);
  const auto lost = lost_edges(other, created);
  removed.insert(removed.end(), lost.begin(), lost.end());

  const SegmentId old_a = a.id, old_b = b.id;
  a.moments.add(b.moments);
  const bool young =
      a.young() && b.young() && may_be_young(e, a.moments.count(), fit_to(a.moments, e.step, -a.fit.normal));
  if (young) {
    a.raw.insert(a.raw.end(), b.raw.begin(), b.raw.end());
  } else {
    for (const RawPoint& raw : a.raw) add_to_relief(e, part, e.world(raw.at), 1);
    add_to_relief(e, part, b);
    a.raw = std::vector<RawPoint>();  // `= {}` would keep the memory
  }
  e.modelled_points += b.moments.count();  // which go when b does
  a.axis_sum += b.axis_sum;
  a.since_sum += b.since_sum;
  a.variance_sum += b.variance_sum;
  where.add(b.polygon->changed);
  erase_segment(e, b);

  e.slot_of.erase(old_a.value);
  a.id = {e.next_segment++};
  e.slot_of[a.id.value] = a.slot;
  a.last_joined = e.counts.points;
  forward_label(e, old_a, a.id);
  forward_label(e, old_b, a.id);
  e.changes.push_back({Change::Kind::merged, old_a, old_b, a.id, {}});
  if (!removed.empty()) e.changes.push_back({Change::Kind::edges_removed, {}, {}, a.id, std::move(removed)});
  return where;
}

}  // namespace

bool merge_polygon_segments(Engine& e, Segment& s1, Segment& s2) {
  const bool first_larger = s1.polygon->perimeter.edge_count() >= s2.polygon->perimeter.edge_count();
  Segment &a = first_larger ? s1 : s2, &b = first_larger ? s2 : s1;
  if (a.initial() || b.initial()) return false;
  if (!within(a.polygon->box, b.polygon->box, e.parameters.resolution) || !planes_agree(e, a, b) ||
      remembered_as_refused(e, a, b) || !may_meet_where_changed(e, s1, s2))
    return false;
  if (!a.polygon->shared.empty() && !b.polygon->shared.empty()) dissolve_neighbours(e, a, b);
  PolygonPart& part = *a.polygon;
  auto other = in_chart_of(e, part.chart, *b.polygon);
  if (!other) return remember_refusal(e, a, b), false;
  other->take_created();
  const std::uint64_t joins_before = part.perimeter.joins();
  const auto merger = merge_perimeters(e, part.perimeter, *other);
  if (merger == geometry::Merger::too_far || merger == geometry::Merger::refused)
    return remember_refusal(e, a, b), false;

  Places where;
  std::vector<geometry::EdgeId> inherited;  // shared edges that come from b, and are not on their lines yet
  with_ends_apart(e, [&] {
    where = take_over(e, a, b, *other, inherited);
    refit(e, a);
    reposition(e, a, inherited);
  });
  keep_one_concavity(e, a, inherited);
  // Who had one edge with each of the two, and others between them, has them in disorder now; and cycles that
  // have become one may be in order each, and not together.
  for (const std::uint32_t n : neighbours_across(e, inherited)) dissolve_disordered(e, e.at(n));
  if (!inherited.empty() || part.perimeter.joins() != joins_before) dissolve_disordered(e, a);
  part.initial = a.fit.plane();
  description_changed(e, a, where);
  update_index(e, a);
  return true;
}

bool merge_modified_polygons(Engine& e) {
  bool any = false;
  const Turn turn = polygons_of(e, e.modified, [](const PolygonPart& part) { return !part.changed.empty(); });
  for (const auto& [id, slot] : turn) {
    Segment* s = e.find(id, slot);
    if (!s) continue;  // merged away in this round; what it became is modified and has its turn next round
    const Turn others = polygons_near(e, s->polygon->changed, slot);
    // After a merger what came of it has its own turn in the next round, with all that had changed of both.
    const bool merged = std::any_of(others.begin(), others.end(), [&](const auto& other) {
      return merge_polygon_segments(e, *s, e.at(other.second));
    });
    if (!merged) s->polygon->changed.clear();
    any |= merged;
  }
  return any;
}

}  // namespace limpet::model::internal
