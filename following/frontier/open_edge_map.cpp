// Copyright the limpet authors. GPL-3.0-or-later.
#include "open_edge_map_internal.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace limpet::following::internal {

using Eigen::Vector3d;
using geometry::EdgeId;
using model::Change;
using model::View;

OpenPart OpenEdgeMap::Entry::part(std::uint32_t i) const {
  const auto count = static_cast<double>(parts.size());
  const Vector3d step = (to - from) / count;
  OpenPart result;
  result.part = i;
  result.state = parts[i];
  result.from = from + i * step;
  result.to = from + (i + 1) * step;
  return result;
}

void OpenEdgeMap::forget(EdgeId id) {
  const auto known = edges_.find(id.value);
  if (known == edges_.end()) return;
  const Entry& entry = known->second;
  for (std::uint32_t i = 0; i < entry.parts.size(); ++i)
    places_.remove(entry.part(i).middle(), [&](const Place& place) { return place.edge == id.value; });
  edges_.erase(known);
}

void OpenEdgeMap::put(EdgeId id, const View& view) {
  forget(id);
  const auto edge = view.edge(id);
  if (!edge || edge->partner) return;
  const double parts = std::ceil((edge->to - edge->from).norm() / part_length_);
  const auto count = static_cast<std::uint32_t>(std::max(1.0, parts));
  Entry entry{edge->from, edge->to, std::vector<PartState>(count, PartState::wanted), false, false};
  for (std::uint32_t i = 0; i < count; ++i) places_.put(entry.part(i).middle(), {id.value, i});
  edges_[id.value] = entry;
}

void OpenEdgeMap::apply(std::span<const Change> changes, const View& view) {
  for (const Change& change : changes) switch (change.kind) {
      case Change::Kind::edges_removed:
      case Change::Kind::shared:
        for (const EdgeId id : change.edges) forget(id);
        break;
      case Change::Kind::edges_created:
      case Change::Kind::edges_moved:
      case Change::Kind::unshared:
        for (const EdgeId id : change.edges) put(id, view);
        break;
      default:
        break;
    }
}

void OpenEdgeMap::read(const View& view) {
  edges_.clear(), places_.clear();
  std::vector<View::Edge> open;
  view.open_edges(open);
  for (const View::Edge& edge : open) put(edge.id, view);
}

void OpenEdgeMap::near(const Vector3d& p, double reach, const View& view, std::vector<OpenPart>& result) {
  result.clear(), found_.clear();
  places_.for_each_within(p, reach, [&](const Vector3d&, const Place& place) { found_.push_back(place); });
  std::sort(found_.begin(), found_.end(), [](const Place& a, const Place& b) {
    return std::tie(a.edge, a.part) < std::tie(b.edge, b.part);
  });
  for (const Place& place : found_) {
    const EdgeId id{place.edge};
    const auto edge = view.edge(id);
    if (!edge || edge->partner) {  // its segment was deleted, or it has a partner
      forget(id);
      continue;
    }
    const Entry& entry = edges_.at(place.edge);
    OpenPart part = entry.part(place.part);
    part.edge = id;
    part.segment = edge->segment;
    part.insist = entry.insist;
    part.closes = entry.closes;
    result.push_back(part);
  }
}

void OpenEdgeMap::set(const OpenPart& part, PartState state) {
  if (const auto known = edges_.find(part.edge.value); known != edges_.end())
    known->second.parts[part.part] = state;
}

void OpenEdgeMap::note(const model::Outcome& outcome) {
  const auto set_closes = [&](std::uint64_t edge, bool closes) {
    if (const auto known = edges_.find(edge); known != edges_.end()) known->second.closes = closes;
  };
  for (const auto& edge : outcome.edges) set_closes(edge.edge.value, edge.closes);
  for (const auto& left : outcome.left)
    places_.for_each_within((left.from + left.to) / 2, part_length_,
                            [&](const Vector3d&, const Place& place) { set_closes(place.edge, false); });
}

bool OpenEdgeMap::insist() {
  bool any = false;
  for (auto& [id, entry] : edges_) {
    if (entry.closes || entry.insist) continue;
    entry.insist = true;
    for (PartState& state : entry.parts)
      if (state == PartState::done) state = PartState::wanted, any = true;
  }
  return any;
}

bool OpenEdgeMap::retry() {
  bool any = false;
  for (auto& [id, entry] : edges_)
    for (PartState& state : entry.parts)
      if (!entry.closes && state == PartState::unreachable) state = PartState::wanted, any = true;
  return any;
}

void OpenEdgeMap::give_up(const Vector3d& p, double reach) {
  places_.for_each_within(p, reach, [&](const Vector3d&, const Place& place) {
    const auto known = edges_.find(place.edge);
    if (known == edges_.end()) return;
    PartState& state = known->second.parts[place.part];
    if (state == PartState::wanted) state = PartState::unreachable;
  });
}

std::vector<OpenPart> OpenEdgeMap::left(const Vector3d& p, const View& view) const {
  std::vector<OpenPart> parts;
  for (const auto& [id, entry] : edges_) {
    const auto edge = entry.closes ? std::nullopt : view.edge({id});
    if (!edge || edge->partner) continue;
    for (std::uint32_t i = 0; i < entry.parts.size(); ++i) {
      if (entry.parts[i] != PartState::unreachable && entry.parts[i] != PartState::wanted) continue;
      parts.push_back(entry.part(i));
      parts.back().edge = {id}, parts.back().segment = edge->segment;
    }
  }
  const auto key = [&](const OpenPart& part) {  // ties do not depend on the order of the map
    return std::tuple((part.middle() - p).norm(), part.edge.value, part.part);
  };
  std::sort(parts.begin(), parts.end(),
            [&](const OpenPart& a, const OpenPart& b) { return key(a) < key(b); });
  return parts;
}

std::optional<Vector3d> OpenEdgeMap::nearest_wanted_of_initial(const Vector3d& p, const View& view) const {
  std::optional<Vector3d> best;
  std::tuple<double, std::uint64_t, std::uint32_t> least;  // ties do not depend on the order of the map
  for (const auto& [id, entry] : edges_) {
    const auto edge = entry.closes ? std::nullopt : view.edge({id});
    if (!edge || view.segment(edge->segment)->kind != View::Kind::initial) continue;
    for (std::uint32_t i = 0; i < entry.parts.size(); ++i) {
      if (entry.parts[i] != PartState::wanted) continue;
      const Vector3d middle = entry.part(i).middle();
      const std::tuple distance{(middle - p).norm(), id, i};
      if (!best || distance < least) best = middle, least = distance;
    }
  }
  return best;
}

std::vector<EdgeId> OpenEdgeMap::edges(PartState state) const {
  std::vector<EdgeId> result;
  for (const auto& [id, entry] : edges_)
    if (!entry.closes && std::find(entry.parts.begin(), entry.parts.end(), state) != entry.parts.end())
      result.push_back({id});
  std::sort(result.begin(), result.end());
  return result;
}

bool OpenEdgeMap::any_wanted(const Vector3d& p, double reach) const {
  return places_.any_within(p, reach, [&](const Vector3d&, const Place& place) {
    const auto known = edges_.find(place.edge);
    return known != edges_.end() && !known->second.closes &&
           known->second.parts[place.part] == PartState::wanted;
  });
}

}  // namespace limpet::following::internal
