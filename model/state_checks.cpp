// Copyright the limpet authors. GPL-3.0-or-later.
//
// Is an engine that was read from bytes one to go on from? Perimeters have been judged before
// (geometry/polygon_state.cpp).
#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "archive_internal.hpp"
#include "engine_internal.hpp"

namespace limpet::model::internal {
namespace {

using geometry::EdgeId;

void require(bool good, const char* what) {
  if (!good) Reader::refuse(what);
}

template <class Slots>
void require_slots(const Engine& e, const Slots& slots) {
  for (const std::uint32_t slot : slots)
    require(slot < e.segments.size(), "names a segment where there is none");
}

void require_free_slots(const Engine& e) {
  std::vector<char> free(e.segments.size());
  require_slots(e, e.free_slots);
  for (const std::uint32_t slot : e.free_slots) {
    require(!e.segments[slot] && !free[slot], "has a place that is free and is not");
    free[slot] = 1;
  }
  require(e.slot_of.size() + e.free_slots.size() == e.segments.size(),
          "has a place that is neither free nor taken");
}

void require_lists(const Engine& e) {
  require_free_slots(e);
  require_slots(e, e.modified);
  require_slots(e, e.to_share);
  require_slots(e, e.share_later);
  for (const auto& [pair, places] : e.looks_due)
    require(pair.first < pair.second && pair.second < e.segments.size(), "has a look due at no pair");
  require(e.counts.points >= 0 && e.looked_at >= 0, "has counts below 0");
  require(e.labels_kept || e.labels.empty(), "has labels that are not kept");
}

/// Sums that can be added to, and divided, without overflow.
void require_moments(const Moments& moments) {
  const MomentsRecord m = moments.record();
  const auto sized = [](Int128 x) { return x < 0 ? -x : x; };
  const Int128 largest = Int128{1} << 124, squared_steps = Int128{kMaxSteps} * kMaxSteps;
  require(m.count >= 0, "has a segment of fewer than no points");
  for (const Int128 sum : m.sum) {
    require(sized(sum) <= Int128{m.count} * kMaxSteps, "has sums that no points have");
    // What the mean is multiplied by.
    const auto x = static_cast<long double>(sum);
    require(m.count == 0 || x * x / static_cast<long double>(m.count) <= static_cast<long double>(largest),
            "has a segment of too many points");
  }
  for (const Int128 product : m.product) {
    require(sized(product) / squared_steps <= m.count, "has sums that no points have");
    require(sized(product) <= largest, "has a segment of too many points");
  }
}

void require_raw_point(const Engine& e, const RawPoint& raw) {
  for (const std::int64_t x : raw.at) require(std::abs(x) <= kMaxSteps, "has a point too far away");
  require(raw.serial < static_cast<std::int64_t>(e.labels.size()), "has a point without a label");
  require(raw.returned >= 0 && raw.since <= e.counts.points, "has a point with a past of its own");
}

void require_segment(const Engine& e, const Segment& s) {
  require(s.id.value > 0 && s.id.value < e.next_segment, "has an identity that was not given yet");
  require_moments(s.moments);
  require(s.polygon || s.moments.count() > 0, "has a segment without points");
  require(!s.young() || static_cast<std::int64_t>(s.raw.size()) == s.moments.count(),
          "has a young segment with other points than it counts");
  for (const RawPoint& raw : s.raw) require_raw_point(e, raw);
  require(s.indexed_as_polygon == (s.polygon != nullptr) && !s.indexed.isEmpty(),
          "has a segment that is not found");
  const double farthest = 0x1p60 * e.parameters.resolution;
  require(s.indexed.min().minCoeff() > -farthest && s.indexed.max().maxCoeff() < farthest,
          "has a segment too far away");
  if (s.polygon) require(s.polygon->chart.step() == e.step, "has a polygon on another grid");
}

void require_edges(const Engine& e) {
  std::unordered_set<std::uint64_t> edges;
  std::size_t shared = 0;
  for (const auto& s : e.segments) {
    if (!s || !s->polygon) continue;
    const geometry::Polygon& perimeter = s->polygon->perimeter;
    for (std::uint32_t i = 0; i < perimeter.slot_count(); ++i) {
      if (!perimeter.alive(geometry::Slot{i})) continue;
      const auto& node = perimeter.node(geometry::Slot{i});
      require(node.edge.value < e.edge_ids.next() && edges.insert(node.edge.value).second,
              "has an edge with another's identity");
      shared += node.shared;
      require(!node.shared || e.shared.count(node.edge.value), "has a shared edge without a partner");
    }
  }
  require(shared == e.shared.size(), "has a pair of edges that are not there");
}

void require_pairs(const Engine& e) {
  for (const auto& [edge, mine] : e.shared) {
    require(mine.segment < e.segments.size() && e.segments[mine.segment] && e.at(mine.segment).polygon,
            "has a shared edge on no polygon");
    const geometry::Polygon& perimeter = e.at(mine.segment).polygon->perimeter;
    require(perimeter.alive(mine.slot) && perimeter.node(mine.slot).edge == EdgeId{edge} &&
                perimeter.node(mine.slot).shared,
            "has a shared edge that is not where it should be");
    const auto other = e.shared.find(mine.partner.value);
    require(other != e.shared.end() && other->second.partner == EdgeId{edge} &&
                other->second.segment != mine.segment,
            "has a shared edge without a partner");
  }
}

}  // namespace

void require_sound(const Engine& e) {
  require_lists(e);
  for (const auto& s : e.segments)
    if (s) require_segment(e, *s);
  for (const RawPoint& raw : e.pending) require_raw_point(e, raw);
  require_edges(e);
  require_pairs(e);
}

}  // namespace limpet::model::internal
