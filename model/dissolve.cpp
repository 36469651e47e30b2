// Copyright the limpet authors. GPL-3.0-or-later.
//
// A young segment whose points mostly belong to a mature neighbour (a sliver across an edge, say) is
// dissolved, and its points find their segments again.
#include <algorithm>
#include <cassert>

#include "engine_internal.hpp"

namespace limpet::model::internal {
namespace {

Box3 box_of(const Engine& e, std::span<const RawPoint> points) {
  Box3 box;
  for (const RawPoint& raw : points) box.extend(e.world(raw.at));
  return box;
}

/// Mature polygons that points of a segment may fit.
void find_mature_polygons(Engine& e, const Box3& around, std::vector<const Segment*>& result) {
  result.clear();
  e.polygons.query(around, e.found);
  for (const std::uint32_t slot : e.found)
    if (const Segment& other = e.at(slot); other.mature_polygon()) result.push_back(&other);
}

bool fits(const Engine& e, const RawPoint& raw, const Segment& polygon) {
  const Eigen::Vector3d p = e.world(raw.at);
  if (!polygon.indexed.contains(p)) return false;
  const double h = polygon.fit.height_of(p);
  return h * h <= residual_limit(e, polygon, p, raw.variance) &&
         standing(e, polygon, p, raw.axis, h * h, raw.variance).near;
}

/// Does a point of the young segment that lies within λ of where the polygon has changed fit it now?
bool fits_where_changed(const Engine& e, const Segment& young, const Segment& polygon) {
  const double lambda2 = e.parameters.resolution * e.parameters.resolution;
  return std::any_of(young.raw.begin(), young.raw.end(), [&](const RawPoint& raw) {
    const Eigen::Vector3d p = e.world(raw.at);
    const double height = polygon.fit.height_of(p);
    if (height * height >= lambda2) return false;
    const auto& places = polygon.polygon->changed.boxes();
    return std::any_of(places.begin(), places.end(),
                       [&](const Box3& place) { return place.squaredExteriorDistance(p) < lambda2; }) &&
           fits(e, raw, polygon);
  });
}

/// Do a fifth of the points fit mature neighbours? Asked only when one that has not been looked at does.
bool mostly_fits_neighbours(Engine& e, Segment& s) {
  static thread_local std::vector<const Segment*> polygons;
  const auto fits_one = [&](const RawPoint& raw) {
    return std::any_of(polygons.begin(), polygons.end(), [&](auto* p) { return fits(e, raw, *p); });
  };
  const std::span<const RawPoint> all(s.raw), unseen = all.subspan(std::min(s.seen, all.size()));
  s.seen = all.size();
  if (unseen.empty()) return false;
  find_mature_polygons(e, box_of(e, unseen), polygons);
  if (std::none_of(unseen.begin(), unseen.end(), fits_one)) return false;
  find_mature_polygons(e, box_of(e, all), polygons);
  std::size_t fitting = 0;
  for (const RawPoint& raw : all) {
    if (raw.returned >= kMaxReturns) return false;
    fitting += fits_one(raw);
  }
  return 5 * fitting >= all.size();
}

/// A young polygon is looked at once more before it becomes mature.
bool came_too_slowly(const Engine& e, const Segment& s, std::int64_t from_count) {
  return e.rules().arrival && s.polygon && s.moments.count() >= from_count &&
         too_few_arrived(e, s.fit, s.since_sum);
}

}  // namespace

void release_slow_polygons(Engine& e) {
  std::vector<std::pair<SegmentId, std::uint32_t>> slow;
  for (const auto& s : e.segments)
    if (s && s->young() && came_too_slowly(e, *s, 0)) slow.emplace_back(s->id, s->slot);
  std::sort(slow.begin(), slow.end());
  for (const auto& [id, slot] : slow) {
    if (Segment* s = e.find(id, slot)) release_points(e, *s, false);
    insert_pending(e);
  }
}

void release_points(Engine& e, Segment& s, bool count_return) {
  assert(static_cast<std::int64_t>(s.raw.size()) == s.moments.count());
  for (RawPoint raw : s.raw) {
    raw.returned += count_return;
    e.pending.push_back(raw);
  }
  if (s.polygon) dissolve_all_neighbours(e, s);  // first, so that the changes are in order
  e.changes.push_back({Change::Kind::deleted, s.id, {}, {}, {}});
  erase_segment(e, s);
}

bool dissolve_young(Engine& e) {
  if (!e.rules().dissolve) return false;
  // Young polygons that were modified, and all young segments near where a mature polygon's description
  // changed. The points of point segments have been tried on all polygons when they came.
  std::vector<std::pair<SegmentId, std::uint32_t>> look;
  for (const std::uint32_t slot : e.modified) {
    if (!e.segments[slot]) continue;
    const Segment& s = e.at(slot);
    if (s.polygon && s.young()) look.emplace_back(s.id, slot);
    if (!s.mature_polygon() || s.polygon->changed.empty()) continue;
    for (const SpatialIndex* index : {&e.polygons, &e.points}) {
      query(*index, s.polygon->changed, e.found);
      for (const std::uint32_t near : e.found)
        if (Segment& young = e.at(near); young.young() && fits_where_changed(e, young, s)) {
          young.seen = 0;
          look.emplace_back(young.id, near);
        }
    }
  }
  std::sort(look.begin(), look.end());
  look.erase(std::unique(look.begin(), look.end()), look.end());
  bool any = false;
  for (const auto& [id, slot] : look) {
    Segment* s = e.find(id, slot);
    if (!s) continue;
    const bool slow = came_too_slowly(e, *s, kYoung * 3 / 4);
    if (!slow && !mostly_fits_neighbours(e, *s)) continue;
    release_points(e, *s, !slow);
    any = true;
  }
  insert_pending(e);
  return any;
}

}  // namespace limpet::model::internal
