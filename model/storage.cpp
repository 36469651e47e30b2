// Copyright the limpet authors. GPL-3.0-or-later.
#include "storage_internal.hpp"

#include <algorithm>

namespace limpet::model::internal {

using geometry::EdgeId;

Segment* Storage::add_segment(Complex& complex, Agenda& agenda, SegmentId id) {
  SegmentTable& table = complex.segments_;
  const std::uint32_t slot = table.slot_count();
  if (!table.slot_of_.emplace(id.value, slot).second) return nullptr;
  table.segments_.push_back(std::make_unique<Segment>());
  Segment& s = *table.segments_.back();
  s.id = id;
  s.slot = slot;
  agenda.opened(slot);
  return &s;
}

void Storage::book_polygon(Complex& complex, Segment& s) {
  complex.agenda_.became_polygon(s.slot);
  s.polygon->perimeter.take_created();
  for_each_edge(s.polygon->perimeter, [&](geometry::Slot slot) {
    complex.edges_.put(s.polygon->perimeter.node(slot).edge, s.slot, slot);
  });
  complex.modelled_points_ += s.count();
  complex.initial_count_ += s.initial();
  if (!s.initial()) complex.count_area(*s.polygon);
}

void Storage::list_segments(Complex& complex, void (*refuse)(const char* what)) {
  SegmentTable& table = complex.segments_;
  for (std::uint32_t slot = 0; slot < table.slot_count(); ++slot) {
    Segment* s = table.in_slot(slot);
    if (!s) continue;
    s->slot = slot;
    if (!table.slot_of_.emplace(s->id.value, slot).second) refuse("has two segments of one identity");
    if (!s->polygon) continue;
    complex.initial_count_ += s->initial();
    geometry::Polygon& perimeter = s->polygon->perimeter;
    // Between two calls every difference is booked; what is left would be booked with the next one.
    if (!perimeter.take_removed().empty() || !perimeter.take_created().empty())
      refuse("has a perimeter that was changed and not booked");
    for_each_edge(perimeter, [&](geometry::Slot vertex) {
      if (complex.edges_.put(perimeter.node(vertex).edge, slot, vertex) != EdgeTable::kNowhere)
        refuse("has an edge with another's identity");
    });
  }
}

void Storage::fill_index(Complex& complex) {
  complex.segments_.for_each([&](const Segment& s) {
    (s.polygon ? complex.segments_.polygons_ : complex.segments_.points_).insert(s.indexed, s.slot);
  });
}

void Storage::pair_edges(Complex& complex, const std::map<EdgeId, EdgeId>& partners,
                         void (*refuse)(EdgeId edge)) {
  EdgeTable& edges = complex.edges_;
  const auto node_of = [&](EdgeId edge) -> const geometry::Polygon::Node* {
    const EdgePlace* place = edges.find(edge);
    return place ? &complex.at(place->segment).polygon->perimeter.node(place->slot) : nullptr;
  };
  for (const auto& [edge, partner] : partners) {
    const auto back = partners.find(partner);
    if (back == partners.end() || back->second != edge || !node_of(edge) || !node_of(partner) ||
        !node_of(edge)->shared || edges.at(edge).segment == edges.at(partner).segment)
      refuse(edge);
    if (edge < partner) edges.pair(edge, partner);
  }
  for (const auto& segment : complex.segments_.segments_) {
    if (!segment || !segment->polygon) continue;
    PolygonPart& part = *segment->polygon;
    part.shared.clear();
    for_each_edge(part.perimeter, [&](geometry::Slot slot) {
      const auto& node = part.perimeter.node(slot);
      if (!node.shared) return;
      if (!edges.shared(node.edge)) refuse(node.edge);
      part.shared.push_back(node.edge);
    });
    std::sort(part.shared.begin(), part.shared.end());
  }
  complex.settle_surfaces();
}

std::map<EdgeId, EdgeId> Storage::partners(const Complex& complex) {
  std::map<EdgeId, EdgeId> partners;
  complex.edges_.for_each([&](EdgeId edge, const EdgePlace& place) {
    if (place.partner) partners.emplace(edge, place.partner);
  });
  return partners;
}

std::map<SegmentId, std::int64_t> Storage::confirmations(const Complex& complex) {
  std::map<SegmentId, std::int64_t> all;
  complex.segments_.for_each([&](const Segment& s) {
    if (s.polygon && s.polygon->confirmed > 0) all.emplace(s.id, s.polygon->confirmed);
  });
  return all;
}

void Storage::set_confirmations(Complex& complex, const std::map<SegmentId, std::int64_t>& all,
                                void (*refuse)(const char* what)) {
  for (const auto& [id, confirmed] : all) {
    const Segment* s = complex.find(id);
    if (!s || !s->initial() || confirmed <= 0) refuse("confirms a segment that is not an initial one");
    complex.mutable_of(*s).polygon->confirmed = confirmed;
  }
}

std::map<SegmentId, SegmentId> Storage::successors(const Successors& successors) {
  std::map<SegmentId, SegmentId> all;
  for (const auto& family : successors.families_)
    for (const std::uint64_t member : family.members) all.emplace(SegmentId{member}, SegmentId{family.now});
  return all;
}

void Storage::set_successors(Successors& successors, const std::map<SegmentId, SegmentId>& all) {
  for (const auto& [member, now] : all) {
    const std::uint32_t family = successors.family_of(now.value);
    if (member == now) continue;
    successors.family_[member.value] = family;
    successors.families_[family].members.push_back(member.value);
  }
}

}  // namespace limpet::model::internal
