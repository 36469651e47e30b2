// Copyright the limpet authors. GPL-3.0-or-later.
#include "sections_internal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <limpet/geometry/predicates.hpp>

#include "chance_internal.hpp"
#include "voids_internal.hpp"

namespace limpet::model::internal {
namespace {

using geometry::EdgeId;
using geometry::Point2;
using geometry::Slot;

/// The point at this place between two stations; if it is within kSameSteps of one of them, that station's
/// vertex.
Station between(const Station& a, const Station& b, double place) {
  const double fraction = (place - a.place) / (b.place - a.place);
  Station s{place, a.offset + fraction * (b.offset - a.offset),
            geometry::round_to_grid(a.at + fraction * (b.at - a.at)), geometry::kNoSlot};
  for (const Station* end : {&a, &b})
    if (geometry::squared_length(s.at - end->at) <= kSameSteps * kSameSteps)
      s.at = end->at, s.vertex = end->vertex, s.offset = end->offset;
  return s;
}

/// The section from an end of a shared edge to another such end; what lies between may overshoot both by a
/// little.
std::optional<Section> between_anchors(const Side& side, double begin, double end, double overshoot) {
  std::optional<std::size_t> first, last;
  for (std::size_t i = 0; i < side.size(); ++i) {
    const double place = side.station(i).place;
    if (place == begin && !first && side.anchor(i)) first = i;
    if (place == end && first && side.anchor(i)) last = i;
  }
  if (!first || !last) return std::nullopt;
  for (std::size_t i = *first; i <= *last; ++i)
    if (side.station(i).place < begin - overshoot || side.station(i).place > end + overshoot)
      return std::nullopt;
  return Section{side.station(*first), side.station(*last), *first, *last - 1, true, true};
}

}  // namespace

LineChain turned(LineChain chain, bool reverse, double sign) {
  if (reverse) {
    std::reverse(chain.stations.begin(), chain.stations.end());
    std::reverse(chain.edges.begin(), chain.edges.end());
  }
  for (Station& s : chain.stations) s.place *= sign, s.offset *= reverse ? -sign : sign;
  return chain;
}

std::optional<Section> section_of(const Side& side, double begin, double end, double overshoot) {
  if (overshoot > 0)
    if (const auto section = between_anchors(side, begin, end, overshoot)) return section;
  std::optional<std::size_t> low;
  for (std::size_t i = 0; i < side.size(); ++i) {
    if (side.station(i).place <= begin) low = i;
    if (side.station(i).place < end || !low || *low == i) continue;
    Section s;
    const Station &a = side.station(*low), &b = side.station(*low + 1);
    s.first_edge = *low, s.last_edge = i - 1;
    if (a.place < begin && side.shared(*low)) return std::nullopt;
    s.begin = a.place == begin ? a : between(a, b, begin);
    s.begin_anchored = a.place == begin && side.anchor(*low);
    const Station &c = side.station(i - 1), &d = side.station(i);
    if (d.place > end && side.shared(i - 1)) return std::nullopt;
    s.end = d.place == end ? d : between(c, d, end);
    s.end_anchored = d.place == end && side.anchor(i);
    return s;
  }
  return std::nullopt;
}

Content content_of(const Side& side, const Section& section) {
  Content content;
  for (std::size_t i = section.first_edge; i <= section.last_edge; ++i) {
    if (side.shared(i)) {
      content.shared.push_back(side.perimeter().node(side.chain->edges[i]).edge);
      continue;
    }
    const double from = std::max(side.station(i).place, section.begin.place),
                 to = std::min(side.station(i + 1).place, section.end.place);
    content.open += std::max(0.0, to - from);
  }
  std::sort(content.shared.begin(), content.shared.end());
  return content;
}

bool gives_way(const Complex& complex, const Side& side, const Section& section) {
  const Setting& setting = complex.setting();
  const Scale scale =
      setting.scale_at(side.origin + (section.begin.place + section.end.place) / 2 * side.along);
  const double lambda = scale.lambda, near = lambda / 4;
  const bool all_felt = side.segment->polygon->all_felt();
  // However empty it may be by chance, nothing reaches out to a line much farther than it then lies on it,
  // unless it lies there on both sides already.
  const double length = section.end.place - section.begin.place;
  const double deepest = section.begin_anchored && section.end_anchored
                             ? std::numeric_limits<double>::max()
                             : std::max(kDeepBay * lambda, kDeepestBay * length);
  // The bay or spur that the walk along the section is in, its signed area (> 0: a bay) and extreme offsets.
  Addition bay = side.frame();
  bay.limits.push_back({{0, 0}, {0, 1}});
  double area = 0, highest = section.begin.offset, lowest = section.begin.offset;
  Station last = section.begin;
  // A section that ends amid a bay adds a piece of it; the next one would add the rest, so that the piece is
  // no limit.
  const auto begin_at = [&](const Station& s) {
    bay.outline.assign({{s.place, 0}, {s.place, s.offset}});
    bay.limits.resize(1);
    if (s.offset < near) bay.limits.push_back({{s.place, 0}, {1, 0}});
  };
  const auto ends = [&] {
    bay.outline.emplace_back(last.place, 0);
    if (last.offset < near) bay.limits.push_back({{last.place, 0}, {-1, 0}});
    const double steps2 = area / (setting.step * setting.step);
    const bool bay_goes = highest <= 0 || (highest < lambda && all_felt) ||
                          (highest < deepest && chance_explains(complex, *side.segment, bay)),
               spur_goes = lowest > -side.reach ||
                           is_spur(setting.rules(), scale.gap, -steps2, -lowest / setting.step);
    area = highest = lowest = 0;
    begin_at(last);
    return bay_goes && spur_goes;
  };
  const auto go_on_to = [&](const Station& next) {
    if (last.offset * next.offset < 0 && !ends()) return false;
    area += (next.place - last.place) * (last.offset + next.offset) / 2;
    bay.outline.emplace_back(next.place, next.offset);
    highest = std::max(highest, next.offset), lowest = std::min(lowest, next.offset);
    last = next;
    return std::abs(next.offset) >= near || ends();
  };
  begin_at(section.begin);
  for (std::size_t i = section.first_edge + 1; i <= section.last_edge; ++i)
    if (!go_on_to(side.station(i))) return false;
  return go_on_to(section.end) && ends();
}

geometry::Edit edit_for(const Side& side, const Section& section, Point2 l1, Point2 l2, EdgeId id) {
  const bool r = side.reversed;
  const Station &first = r ? section.end : section.begin, &last = r ? section.begin : section.end;
  const bool first_anchored = r ? section.end_anchored : section.begin_anchored,
             last_anchored = r ? section.begin_anchored : section.end_anchored;
  const Slot first_edge = side.chain->edges[r ? section.last_edge : section.first_edge],
             last_edge = side.chain->edges[r ? section.first_edge : section.last_edge];
  if (r) std::swap(l1, l2);
  const bool first_cut = first.vertex == geometry::kNoSlot, last_cut = last.vertex == geometry::kNoSlot;

  geometry::Chain chain{
      first_cut ? first_edge : first.vertex, {}, last_cut ? side.perimeter().next(last_edge) : last.vertex};
  if (first_cut && first.at != l1) chain.via.push_back({first.at});
  if (!first_cut && (first_anchored || first.at == l1)) {
    chain.edge = id, chain.shared = true;
  } else {
    chain.via.push_back({l1, id, true});
  }
  if (last_cut || (!last_anchored && last.at != l2)) chain.via.push_back({l2});
  if (last_cut && last.at != l2) chain.via.push_back({last.at});
  geometry::Edit edit;
  edit.chains.push_back(std::move(chain));
  return edit;
}

}  // namespace limpet::model::internal
