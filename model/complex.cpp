// Copyright the limpet authors. GPL-3.0-or-later.
//
// Segments and the sensor points behind them.
#include "complex_internal.hpp"

#include <algorithm>

#include "heights_internal.hpp"
#include "young_internal.hpp"

namespace limpet::model::internal {

using geometry::EdgeId;

Turn polygons_near(const Complex& complex, const DirtyRegion& places, std::uint32_t but) {
  Turn near;
  for_each_near(complex.polygons(), places, [&](std::uint32_t slot) {
    if (slot != but) near.emplace_back(complex.at(slot).id, slot);
  });
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return near;
}

std::vector<std::vector<SegmentId>> surfaces_of(const Complex& complex) {
  std::vector<std::vector<SegmentId>> result;
  complex.segments().for_each([&](const Segment& s) {
    const auto members = complex.surfaces().with(s.slot);
    if (!members.empty() && members.front() != s.slot) return;  // each surface is added at its first member
    auto& surface = result.emplace_back();
    if (members.empty()) surface.push_back(s.id);
    for (const std::uint32_t slot : members) surface.push_back(complex.at(slot).id);
    std::sort(surface.begin(), surface.end());
  });
  std::sort(result.begin(), result.end());
  return result;
}

void Complex::settle_surfaces() {
  const auto links = edges_.take_changed_links();
  if (links.empty()) return;
  surfaces_.update(links, {[&](std::uint32_t a, std::uint32_t b) { return !edges_.between(a, b).empty(); },
                           [&](std::uint32_t slot, std::vector<std::uint32_t>& neighbours) {
                             const Segment* s = in_slot(slot);
                             if (!s || !s->polygon) return;
                             for (const EdgeId edge : s->polygon->shared)
                               neighbours.push_back(edges_.across(edge).segment);
                           }});
}

const Segment& Complex::create_point_segment(const RawPoint& raw) {
  Segment& s = segments_.create();
  agenda_.opened(s.slot);
  s.data = SegmentData(raw, now_);
  s.fit = fit_to(s.data.moments(), setting_.step, s.data.axis_sum());
  agenda_.mark_modified(s.slot);
  changes_.add(Change::Kind::created, {}, {}, s.id);
  return s;
}

/// Takes a segment out of all tables; edges that others share with it become open. Returns the edges that are
/// gone with it.
std::vector<EdgeId> Complex::erase(Segment& s) {
  std::vector<EdgeId> gone;
  if (s.polygon) {
    dissolve_all_neighbours(s);
    for_each_edge(s.polygon->perimeter, [&](geometry::Slot slot) {
      const EdgeId edge = s.polygon->perimeter.node(slot).edge;
      const EdgePlace* place = edges_.find(edge);  // on another segment, if this one merged into it
      if (place && place->segment == s.slot) gone.push_back(edge);
    });
    for (const EdgeId edge : gone) edges_.erase(edge);
    initial_count_ -= s.initial();
    modelled_area_ -= s.polygon->counted_area;
    modelled_points_ -= s.count();
  }
  surfaces_.remove(s.slot);
  agenda_.closed(s.slot);
  segments_.erase(s);
  return gone;
}

void Complex::remove(const Segment& s) {
  if (s.polygon) dissolve_all_neighbours(s);  // first, so that `unshared` is reported before `deleted`
  changes_.add(Change::Kind::deleted, s.id, {}, {});
  erase(mutable_of(s));
}

/// Makes a young polygon mature: its points go into its height map and are dropped.
void Complex::forget_points(Segment& s) {
  for (const RawPoint& raw : s.data.raw()) add_height(setting_, *s.polygon, setting_.world(raw.at), 1);
  s.data.forget_points();
}

void Complex::absorb(const Segment& into, const RawPoint& raw) {
  Segment& s = mutable_of(into);
  const bool was_young = s.young();
  s.data.absorb(raw, now_);
  ++modelled_points_;
  if (!was_young) {
    if (setting_.relief_kept()) add_height(setting_, *s.polygon, setting_.world(raw.at), 1);
  } else if (!may_be_young(setting_, s.count(), s.fit)) {
    become_mature(s);
  }
}

void Complex::become_mature(Segment& s) {
  forget_points(s);
  agenda_.look_for_neighbours(s.slot, s.polygon->box);
}

void Complex::absorb_data(Segment& s, const Segment& other, bool stays_young) {
  if (s.polygon) {
    if (!stays_young) {
      forget_points(s);
      add_heights(setting_, *s.polygon, other);
    }
    modelled_points_ += other.count();  // erase() subtracts them again if `other` is a polygon
  }
  s.data.absorb(other.data, stays_young, now_);
}

void Complex::absorb(const Segment& into, const Segment& from, bool stays_young) {
  absorb_data(mutable_of(into), from, stays_young);
  if (into.polygon && !stays_young) agenda_.look_for_neighbours(into.slot, into.polygon->box);
  const SegmentId gone = from.id;
  const auto lost = erase(mutable_of(from));
  changes_.add(Change::Kind::merged, into.id, gone, into.id);
  changes_.add(Change::Kind::edges_removed, into.id, lost);
}

void Complex::absorb_united(const Segment& into, const Segment& from, bool stays_young) {
  absorb_data(mutable_of(into), from, stays_young);
  const SegmentId old_id = into.id, gone = from.id;
  Owned<Felt>& felt = mutable_of(into).polygon->felt;
  if (felt && from.polygon->felt)
    felt->add(std::move(*mutable_of(from).polygon->felt));
  else
    felt.reset();
  if (const Owned<Passages>& theirs = from.polygon->passages) {
    Owned<Passages>& passages = mutable_of(into).polygon->passages;
    if (!passages) passages = std::make_unique<Passages>();
    passages->add(*theirs, kPassagesApart * setting_.scale_at(into.fit.centroid).lambda);
  }
  const auto lost = erase(mutable_of(from));
  segments_.rename(mutable_of(into));
  changes_.add(Change::Kind::merged, old_id, gone, into.id);
  changes_.add(Change::Kind::edges_removed, into.id, lost);
}

void Complex::note_passage(const Segment& s, const Eigen::Vector3d& at, std::int64_t through) {
  Owned<Passages>& passages = mutable_of(s).polygon->passages;
  if (!passages) passages = std::make_unique<Passages>();
  passages->add(at, kPassagesApart * setting_.scale_at(at).lambda);
  if (through > 0) passages->note_through(through);
}

void Complex::keep_felt(const Segment& s) {
  PolygonPart& part = *mutable_of(s).polygon;
  if (rules().voids && !part.felt)
    part.felt = std::make_unique<Felt>(setting_, part.chart, part.perimeter, s.count());
}

void Complex::felt_at(const Segment& s, const Eigen::Vector3d& p) {
  Owned<Felt>& felt = mutable_of(s).polygon->felt;
  if (felt && agenda_.finishing)
    felt->add(p);
  else
    felt.reset();
}

void Complex::note_addition(const Segment& s) {
  if (Owned<Felt>& felt = mutable_of(s).polygon->felt) felt->note_addition();
}

void Complex::allow_returns() {
  segments_.for_each([&](const Segment& s) { mutable_of(s).data.allow_returns(); });
}

void Complex::set_fit(const Segment& s, const Fit& fit, std::int64_t next_fit) {
  mutable_of(s).fit = fit;
  mutable_of(s).next_fit = next_fit;
}

void Complex::set_initial_plane(const Segment& s, const geometry::Plane& plane) {
  mutable_of(s).polygon->initial = plane;
}

void Complex::set_stale(const Segment& s, bool stale) { mutable_of(s).polygon->stale = stale; }

}  // namespace limpet::model::internal
