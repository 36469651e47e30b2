// Copyright the limpet authors. GPL-3.0-or-later.
//
// Checks that an engine read from bytes can be used safely. Its perimeters have been judged already
// (geometry/polygon_state.cpp).
#include <cmath>

#include "archive_internal.hpp"
#include "record_internal.hpp"
#include "state_internal.hpp"
#include "storage_internal.hpp"

namespace limpet::model::internal {
namespace {

using geometry::EdgeId;

void require_state(bool good, const char* what) {
  if (!good) Reader::refuse(what);
}

template <class Slots>
void require_slots(const Engine& e, const Slots& slots) {
  for (const std::uint32_t slot : slots)
    require_state(slot < e.complex.segments().slot_count(), "names a segment where there is none");
}

void require_free_slots(const Complex& complex) {
  const std::uint32_t slots = complex.segments().slot_count();
  std::vector<char> free(slots);
  const auto& free_slots = Storage::free_slots(complex);
  for (const std::uint32_t slot : free_slots) {
    require_state(slot < slots && !complex.in_slot(slot) && !free[slot],
                  "has a place that is free and is not");
    free[slot] = 1;
  }
  require_state(complex.segments().size() + free_slots.size() == slots,
                "has a place that is neither free nor taken");
}

void require_lists(const Engine& e) {
  require_free_slots(e.complex);
  require_slots(e, Storage::modified(e.agenda));
  require_slots(e, Storage::to_share(e.agenda));
  require_slots(e, Storage::share_later(e.agenda));
  for (const auto& [pair, places] : Storage::looks_due(e.agenda))
    require_state(pair.first < pair.second && pair.second < e.complex.segments().slot_count(),
                  "has a look due at no pair");
  require_state(e.complex.now() >= 0 && Storage::looked_at(e.agenda) >= 0, "has counts below 0");
  require_state(e.labels.kept() || e.labels.size() == 0, "has labels that are not kept");
}

void require_raw_point(const Engine& e, const RawPoint& raw) {
  for (const std::int64_t x : raw.at) require_state(std::abs(x) <= kMaxSteps, "has a point too far away");
  require_state(!e.labels.kept() || raw.serial < static_cast<std::int64_t>(e.labels.size()),
                "has a point without a label");
  require_state(raw.returned >= 0 && raw.since <= e.complex.now(), "has a point with a past of its own");
}

void require_felt(const Engine& e, const Felt& felt) {
  require_state(!felt.parts().empty(), "was felt nowhere");
  for (const Felt::Part& part : felt.parts()) {
    require_state(part.points >= 0 && part.area > 0 && part.thinning > 0, "was felt nowhere");
    require_state(part.chart.step() == e.setting.step, "was felt on another grid");
  }
}

void require_passages(const Passages& passages) {
  require_state(passages.rays() >= 0 && passages.through() >= passages.rays() &&
                    passages.places().size() <= kMostPassages,
                "has readings that passed too often");
  for (const Passages::Place& place : passages.places())
    require_state(place.at.allFinite() && place.count > 0, "has a place that no reading has passed");
}

void require_segment(const Engine& e, const Segment& s) {
  require_state(s.id.value > 0 && s.id.value < Storage::next_segment(e.complex),
                "has an identity that was not given yet");
  require_state(!fault_of(s.data.moments().record()),
                "has a segment with sums that no points have, or that are too many");
  require_state(s.polygon || s.count() > 0, "has a segment without points");
  require_state(!s.young() || static_cast<std::int64_t>(s.data.raw().size()) == s.count(),
                "has a young segment with other points than it counts");
  for (const RawPoint& raw : s.data.raw()) require_raw_point(e, raw);
  require_state(s.indexed_as_polygon == bool(s.polygon) && !s.indexed.isEmpty(),
                "has a segment that is not found");
  const double farthest = 0x1p60 * e.setting.least.lambda;
  require_state(s.indexed.min().minCoeff() > -farthest && s.indexed.max().maxCoeff() < farthest,
                "has a segment too far away");
  require_state(Storage::has_polygon_due(e.agenda, s.slot) == bool(s.polygon),
                "has a worklist of a segment of another kind");
  if (!s.polygon) return;
  require_state(s.polygon->chart.step() == e.setting.step, "has a polygon on another grid");
  if (s.polygon->felt) require_felt(e, *s.polygon->felt);
  if (s.polygon->passages) require_passages(*s.polygon->passages);
}

}  // namespace

void require_sound(const Engine& e, const std::map<SegmentId, SegmentId>& successors) {
  require_lists(e);
  e.complex.segments().for_each([&](const Segment& s) { require_segment(e, s); });
  for (const RawPoint& raw : e.insertion.pending()) require_raw_point(e, raw);
  e.complex.edges().for_each([&](EdgeId edge, const EdgePlace&) {
    require_state(edge.value < e.complex.next_edge(), "has an edge with an identity that was not given yet");
  });
  for (const auto& [member, now] : successors)
    require_state(member <= now && e.complex.find(now) && (member == now || !e.complex.find(member)),
                  "tells of mergers that were none");
}

}  // namespace limpet::model::internal
