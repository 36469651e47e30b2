// Copyright the limpet authors. GPL-3.0-or-later.
//
// Updating the surface model by a set of sensor points (thesis §2.3).
#include <cmath>
#include <utility>

#include "engine_internal.hpp"

namespace limpet::model::internal {
namespace {

constexpr int kMaxMergeRounds = 50;
constexpr int kMaxFinishRounds = 20;
constexpr std::int64_t kSmall = 5;  ///< point segments below this may expire

/// The reading on the model's grid, or nothing when it is no point.
std::optional<RawPoint> on_grid(const Engine& e, const SensorPoint& reading) {
  RawPoint raw;
  const double length2 = reading.axis.dot(reading.axis);
  if (!(length2 > 0) || !std::isfinite(length2)) return std::nullopt;
  raw.axis = reading.axis / std::sqrt(length2);
  raw.variance = e.variance_at(reading.range);
  if (!std::isfinite(raw.variance)) return std::nullopt;
  for (int i = 0; i < 3; ++i) {
    const double steps = std::floor(reading.position[i] / e.step + 0.5);
    if (!(std::abs(steps) <= static_cast<double>(kMaxSteps))) return std::nullopt;
    raw.at[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(steps);
  }
  return raw;
}

/// Step 1, and step 2a for points: each reading becomes a point segment that merges with its best neighbour.
void insert_readings(Engine& e, std::span<const SensorPoint> set) {
  for (const SensorPoint& reading : set) {
    auto raw = on_grid(e, reading);
    if (e.labels_kept) e.labels.push_back(0);
    if (!raw) {
      ++e.counts.refused;
      continue;
    }
    if (e.labels_kept) raw->serial = static_cast<std::int64_t>(e.labels.size()) - 1;
    ++e.counts.points;
    insert_point(e, *raw);
    insert_pending(e);
  }
}

/// Steps 2 and 3; whether anything changed.
bool mergers_and_fissures(Engine& e) {
  bool any = dissolve_young(e);
  e.stage_clock.lap(&StageTimes::dissolving);
  for (int round = 0; round < kMaxMergeRounds && merge_modified_polygons(e); ++round) any = true;
  e.stage_clock.lap(&StageTimes::mergers);
  any |= fill_modified(e);
  e.stage_clock.lap(&StageTimes::fissures);
  return any;
}

/// Steps 4 and 5; whether anything changed.
bool shared_edges_and_corners(Engine& e) {
  bool any = share_modified(e);
  any |= form_corners_of_modified(e);
  any |= delete_redundant(e);
  e.stage_clock.lap(&StageTimes::sharing);
  return any;
}

/// Step 6.
void clear_flags(Engine& e) {
  for (const std::uint32_t slot : e.modified)
    if (e.segments[slot]) e.segments[slot]->modified = false;
  e.modified.clear();
}

void expire_outliers(Engine& e) {
  if (!e.rules().expiry) return;
  while (!e.by_age.empty() && e.by_age.front().first + e.parameters.outlier_patience < e.counts.points) {
    const auto [joined, id] = e.by_age.front();
    e.by_age.pop_front();
    Segment* s = e.find(id);
    if (!s || s->polygon) continue;
    const bool idle = s->last_joined == joined && s->moments.count() < kSmall;
    if (!idle && !(e.rules().arrival && points_came_too_slowly(e, *s))) continue;
    e.counts.expired += s->moments.count();
    e.changes.push_back({Change::Kind::deleted, s->id, {}, {}, {}});
    erase_segment(e, *s);
  }
}

void release_all_point_segments(Engine& e) {
  std::vector<SegmentId> ids;
  for (const auto& s : e.segments)
    if (s && !s->polygon && s->young()) ids.push_back(s->id);
  std::sort(ids.begin(), ids.end());
  for (const SegmentId id : ids) {
    Segment* s = e.find(id);
    if (!s || s->polygon || !s->young()) continue;  // a point released before may have made it a polygon
    release_points(e, *s, false);
    insert_pending(e);
  }
}

bool drop_all_chance_holes(Engine& e) {
  bool any = false;
  if (e.rules().voids)
    for (const auto& s : e.segments)
      if (s && s->polygon) any |= drop_chance_holes(e, *s);
  return any;
}

/// Marks what the last round left changed.
void mark_changed(Engine& e) {
  for (const auto& s : e.segments)
    if (s && s->polygon &&
        !(s->polygon->changed.empty() && s->polygon->fresh.empty() && s->polygon->unshared.empty() &&
          s->polygon->corners_due.empty()))
      mark_modified(e, *s);
}

void mark_all(Engine& e) {
  for (const auto& s : e.segments) {
    if (!s) continue;
    mark_modified(e, *s);
    if (!s->polygon) continue;
    s->polygon->changed.add(s->polygon->box);
    s->polygon->unshared = e.parameters.neighbours ? Places(s->polygon->box) : Places();
    s->polygon->corners_due = s->polygon->shared;
    s->polygon->fresh.clear();
    for (std::uint32_t i = 0; i < s->polygon->perimeter.slot_count(); ++i)
      if (const geometry::Slot slot{i}; s->polygon->perimeter.alive(slot))
        s->polygon->fresh.emplace_back(slot, s->polygon->perimeter.node(slot).edge);
  }
}

void until_nothing_changes(Engine& e) {
  e.disordered.clear();
  for (int round = 0; round < kMaxFinishRounds; ++round) {
    const bool any = mergers_and_fissures(e) || drop_all_chance_holes(e) || shared_edges_and_corners(e);
    clear_flags(e);
    e.stage_clock.lap(&StageTimes::rest);
    if (!any) break;
    mark_changed(e);
  }
}

/// What is still open may be so by chance: sections are looked for farther from their lines. Then short edges
/// may make neighbours, too, where long ones have not met in a corner.
void close_what_is_open(Engine& e) {
  const SharingReach last = last_reach(e);
  for (const SharingReach& reach : {SharingReach{last.section, e.sharing.least}, last}) {
    const SharingReach before = std::exchange(e.sharing, reach);
    mark_all(e);
    until_nothing_changes(e);
    e.sharing = before;
  }
}

}  // namespace

SharingReach last_reach(const Engine& e) { return {e.rules().voids ? 5.0 : 1.0, 0.25}; }

void update_set(Engine& e, std::span<const SensorPoint> set) {
  e.changes.clear();
  e.disordered.clear();
  e.stage_clock.start();
  insert_readings(e, set);
  e.stage_clock.lap(&StageTimes::insertion);
  mergers_and_fissures(e);
  shared_edges_and_corners(e);
  clear_flags(e);
  expire_outliers(e);
  e.stage_clock.lap(&StageTimes::rest);
  ++e.counts.sets;
}

void finish(Engine& e) {
  e.changes.clear();
  if (!e.rules().finish) return;
  e.stage_clock.start();
  e.finishing = true;
  for (const auto& s : e.segments)
    if (s && s->polygon) refit(e, *s);
  for (const auto& s : e.segments)  // the model has grown since: all points may try again
    if (s)
      for (RawPoint& raw : s->raw) raw.returned = 0;
  release_slow_polygons(e);
  release_all_point_segments(e);
  mark_all(e);
  e.refused_pairs.clear();
  e.stage_clock.lap(&StageTimes::rest);
  until_nothing_changes(e);
  if (e.parameters.neighbours) close_what_is_open(e);
  e.finishing = false;
}

}  // namespace limpet::model::internal
