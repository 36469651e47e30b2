// Copyright the limpet authors. GPL-3.0-or-later.
//
// Updating the surface model by a set of sensor points (thesis §2.3).
#include <cmath>
#include <utility>

#include "dissolve_internal.hpp"
#include "engine_internal.hpp"
#include "fissures_internal.hpp"
#include "initial_internal.hpp"
#include "merging_internal.hpp"
#include "pinches_internal.hpp"
#include "promotion_internal.hpp"
#include "publish_internal.hpp"
#include "rays_internal.hpp"
#include "redundancy_internal.hpp"
#include "sharing_internal.hpp"
#include "strays_internal.hpp"
#include "voids_internal.hpp"

namespace limpet::model::internal {
namespace {

/// The reading rounded to the model's grid, or nothing when it is no point (Model::update()).
std::optional<RawPoint> on_grid(const Setting& setting, const SensorPoint& reading) {
  RawPoint raw;
  const double length2 = reading.axis.dot(reading.axis);
  if (!(length2 > 0) || !std::isfinite(length2)) return std::nullopt;
  raw.axis = reading.axis / std::sqrt(length2);
  raw.variance = setting.variance_at(reading.range);
  if (!std::isfinite(raw.variance)) return std::nullopt;
  for (int i = 0; i < 3; ++i) {
    const double steps = std::floor(reading.position[i] / setting.step + 0.5);
    if (!(std::abs(steps) <= static_cast<double>(kMaxSteps))) return std::nullopt;
    raw.at[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(steps);
  }
  return raw;
}

/// Step 1, and step 2a for points: each reading is inserted into the segment that it fits best.
void insert_readings(Engine& e, std::span<const SensorPoint> set) {
  for (const SensorPoint& reading : set) {
    auto raw = on_grid(e.setting, reading);
    const std::int64_t serial = e.labels.add();
    if (!raw) {
      ++e.counts.refused;
      continue;
    }
    raw->serial = serial;
    e.complex.tick();
    e.insertion.insert(*raw);
    note_passages(e, *raw, reading.range);
  }
  e.clock.lap(&StageTimes::insertion);
}

/// Steps 2 and 3. Returns whether anything changed.
bool mergers_and_fissures(Engine& e) {
  bool any = dissolve_young(e.complex, e.agenda, e.insertion);
  e.clock.lap(&StageTimes::dissolving);
  for (int round = 0; round < kMaxMergeRounds && merge_modified_polygons(e.complex, e.agenda); ++round)
    any = true;
  if (e.agenda.finishing) any |= cut_at_pinches(e.complex, e.agenda);
  e.clock.lap(&StageTimes::mergers);
  any |= fill_modified(e.complex, e.agenda);
  e.clock.lap(&StageTimes::fissures);
  return any;
}

/// Steps 4 and 5, and deleting redundant segments. Returns whether anything changed.
bool shared_edges_and_corners(Engine& e) {
  bool any = share_modified(e.complex, e.agenda);
  any |= form_corners_of_modified(e.complex, e.agenda);
  any |= delete_redundant(e.complex, e.agenda, e.labels, e.counts);
  e.clock.lap(&StageTimes::sharing);
  return any;
}

void expire_outliers(Engine& e) {
  if (!e.setting.rules().expiry) return;
  const std::int64_t before = e.complex.now() - e.setting.parameters.outlier_patience;
  while (const auto aged = e.agenda.take_aged(before)) {
    const auto [joined, id] = *aged;
    const Segment* s = e.complex.find(id);
    if (!s || s->polygon) continue;
    const bool idle = s->data.last_joined() == joined && s->count() < kFewestKept;
    if (!idle && !(e.setting.rules().arrival && points_came_too_slowly(e.complex, *s))) continue;
    e.counts.expired += s->count();
    e.complex.remove(*s);
  }
}

bool drop_all_chance_holes(Engine& e) {
  bool any = false;
  if (e.setting.rules().voids)
    e.complex.segments().for_each([&](const Segment& s) {
      if (s.polygon && !e.agenda.stopped()) any |= drop_chance_holes(e.complex, s);
    });
  return any;
}

/// Marks the polygons that the last round has left with something to look at.
void mark_changed(Engine& e) {
  e.complex.segments().for_each([&](const Segment& s) {
    if (!s.polygon) return;
    const PolygonDue& due = e.agenda.polygon(s.slot);
    if (!(due.changed.empty() && due.fresh.empty() && due.unshared.empty() && due.corners_due.empty()))
      e.agenda.mark_modified(s.slot);
  });
}

void mark_all(Engine& e) {
  e.complex.segments().for_each([&](const Segment& s) {
    e.agenda.mark_modified(s.slot);
    if (!s.polygon) return;
    const PolygonPart& part = *s.polygon;
    PolygonDue& due = e.agenda.polygon(s.slot);
    due.changed.add(part.box);
    due.unshared = e.setting.parameters.neighbours ? DirtyRegion(part.box) : DirtyRegion();
    due.corners_due = part.shared;
    due.no_pinch = 0;
    due.fresh.clear();
    for_each_edge(part.perimeter,
                  [&](geometry::Slot slot) { due.fresh.emplace_back(slot, part.perimeter.node(slot).edge); });
  });
}

void until_nothing_changes(Engine& e) {
  e.agenda.forget_disorder();
  for (int round = 0; round < kMaxFinishRounds; ++round) {
    const bool any = mergers_and_fissures(e) || drop_all_chance_holes(e) || shared_edges_and_corners(e);
    e.agenda.clear_modified();
    e.clock.lap(&StageTimes::rest);
    if (!any || e.agenda.stopped()) break;
    mark_changed(e);
  }
}

/// Mergers and fissures close gaps below λ, which is no addition; after them, the perimeters are what
/// readings made.
void keep_what_was_felt(Engine& e) {
  for (int round = 0; round < kMaxFinishRounds && mergers_and_fissures(e) && !e.agenda.stopped(); ++round)
    mark_changed(e);
  e.complex.segments().for_each([&](const Segment& s) {
    if (s.polygon && !s.initial()) e.complex.keep_felt(s);
  });
}

/// Edges may still be open because of chance gaps, so sections are searched for farther from their lines.
/// After that, short edges may make neighbours as well, where longer ones have not met in a corner.
void close_what_is_open(Engine& e) {
  const SharingReach last = last_reach(e.setting.rules());
  for (const SharingReach& reach : {SharingReach{last.section, e.agenda.sharing.least, true},
                                    SharingReach{last.section, last.least, true}}) {
    if (e.agenda.stopped()) return;
    const SharingReach before = std::exchange(e.agenda.sharing, reach);
    mark_all(e);
    until_nothing_changes(e);
    e.agenda.sharing = before;
  }
}

void begin_call(Engine& e) {
  e.complex.forget_changes();
  e.clock.start();
}

void end_call(Engine& e) {
  e.complex.settle_changes();
  e.labels.follow(e.complex.changes());
  e.labels.tidy(e.complex.segments());
  e.successors.follow(e.complex.changes());
  e.complex.settle_surfaces();
  e.clock.lap(&StageTimes::rest);
}

}  // namespace

SharingReach last_reach(const Rules& rules) {
  return {rules.voids ? kLastSectionReach : kSectionReach, kLastLeastNeighbours};
}

void add_initial_faces(Engine& e, std::span<const InitialFace> faces) {
  begin_call(e);
  try {
    internal::add_initial(e.complex, faces);
  } catch (const Refused&) {  // the faces before it stay
    end_call(e);
    throw;
  }
  end_call(e);
}

void update_set(Engine& e, std::span<const SensorPoint> set) {
  begin_call(e);
  if (!set.empty()) {  // nothing has come, so nothing is due that was not before: law 9 of Model
    e.agenda.forget_disorder();
    insert_readings(e, set);
    delete_passed(e);
    mergers_and_fissures(e);
    shared_edges_and_corners(e);
    e.agenda.clear_modified();  // step 6
    expire_outliers(e);
  }
  end_call(e);
  ++e.counts.sets;
}

void finish(Engine& e, const std::function<bool()>& stop) {
  begin_call(e);
  if (e.setting.rules().finish) {
    e.agenda.stop = stop;
    e.agenda.finishing = e.agenda.sharing.from_shared = true;
    e.complex.segments().for_each([&](const Segment& s) {
      if (s.polygon && !e.agenda.stopped()) refit(e.complex, e.agenda, s);
    });
    e.complex.allow_returns();  // the model has grown since, so all points may be inserted again
    release_slow_polygons(e.complex, e.insertion);
    part_from_strays(e.complex, e.insertion);
    release_all_point_segments(e.complex, e.insertion);
    mark_all(e);
    e.agenda.forget_refusals([](const SegmentPair&) { return true; });
    e.clock.lap(&StageTimes::rest);
    keep_what_was_felt(e);
    until_nothing_changes(e);
    if (e.setting.parameters.neighbours) close_what_is_open(e);
    e.agenda.finishing = e.agenda.sharing.from_shared = false;
    e.agenda.stop = nullptr;
    e.agenda.forget_partings();
  }
  end_call(e);
}

}  // namespace limpet::model::internal
