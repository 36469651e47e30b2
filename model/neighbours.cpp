// Copyright the limpet authors. GPL-3.0-or-later.
//
// Who shares which edge with whom (thesis §2.2), and unsharing (§2.8). The registry knows both copies of
// every shared edge by identity; coordinates decide nothing here but whether two ends still coincide.
#include <algorithm>
#include <array>
#include <cmath>

#include "common_line_internal.hpp"
#include "engine_internal.hpp"

namespace limpet::model::internal {
namespace {

using geometry::EdgeId;
using geometry::Slot;

void insert_sorted(std::vector<EdgeId>& edges, EdgeId edge) {
  const auto at = std::lower_bound(edges.begin(), edges.end(), edge);
  if (at == edges.end() || *at != edge) edges.insert(at, edge);
}

void erase_sorted(std::vector<EdgeId>& edges, EdgeId edge) {
  const auto at = std::lower_bound(edges.begin(), edges.end(), edge);
  if (at != edges.end() && *at == edge) edges.erase(at);
}

std::uint64_t pair_key(std::uint32_t a, std::uint32_t b) {
  return (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
}

/// Takes a pair into the list of its two segments, or out of it.
void list_pair(Engine& e, EdgeId edge) {
  const SharedEdge &mine = e.shared.at(edge.value), &other = e.shared.at(mine.partner.value);
  insert_sorted(e.neighbour_edges[pair_key(mine.segment, other.segment)],
                mine.segment < other.segment ? edge : mine.partner);
}
void unlist_pair(Engine& e, EdgeId edge) {
  const SharedEdge &mine = e.shared.at(edge.value), &other = e.shared.at(mine.partner.value);
  const auto entry = e.neighbour_edges.find(pair_key(mine.segment, other.segment));
  erase_sorted(entry->second, mine.segment < other.segment ? edge : mine.partner);
  if (entry->second.empty()) e.neighbour_edges.erase(entry);
}

/// Takes one copy out of the books; the edge itself may be gone already.
void forget(Engine& e, EdgeId edge) {
  const auto entry = e.shared.find(edge.value);
  Segment& s = e.at(entry->second.segment);
  const Slot slot = entry->second.slot;
  e.shared.erase(entry);
  PolygonPart& part = *s.polygon;
  erase_sorted(part.shared, edge);
  if (slot == geometry::kNoSlot || !part.perimeter.alive(slot) || part.perimeter.node(slot).edge != edge)
    return;
  part.perimeter.set_shared(slot, false);
  Box3 where(part.position(slot));
  description_changed(e, s, where.extend(part.position(part.perimeter.next(slot))));
}

/// Do the ends of the copies meet, but for corners?
bool ends_meet(const Engine& e, EdgeId edge) {
  const SharedEdge &mine = e.shared.at(edge.value), &other = across(e, edge);
  if (mine.slot == geometry::kNoSlot || other.slot == geometry::kNoSlot)
    return true;  // about to be put there
  const Segment &a = e.at(mine.segment), &b = e.at(other.segment);
  const double sine = sine_between(a.polygon->plane(), b.polygon->plane());
  const double reach = kEndSteps * e.step / sine;
  const auto meet = [&](Slot p, Slot q) {
    if (is_corner(e, a, p) || is_corner(e, b, q)) return true;
    return (a.polygon->position(p) - b.polygon->position(q)).squaredNorm() <= reach * reach;
  };
  return meet(mine.slot, b.polygon->perimeter.next(other.slot)) &&
         meet(a.polygon->perimeter.next(mine.slot), other.slot);
}

/// Shared edges before and after this one on its perimeter, of which it may have been a corner partner.
void adjoining(const Engine& e, EdgeId edge, std::vector<EdgeId>& result) {
  const SharedEdge& entry = e.shared.at(edge.value);
  if (entry.slot == geometry::kNoSlot) return;
  const auto& perimeter = e.at(entry.segment).polygon->perimeter;
  if (!perimeter.alive(entry.slot) || perimeter.node(entry.slot).edge != edge) return;
  for (const Slot s : {perimeter.prev(entry.slot), perimeter.next(entry.slot)})
    if (perimeter.node(s).shared) result.push_back(perimeter.node(s).edge);
}

}  // namespace

bool is_corner(const Engine& e, const Segment& s, Slot vertex) {
  const auto& perimeter = s.polygon->perimeter;
  const auto &before = perimeter.node(perimeter.prev(vertex)), &after = perimeter.node(vertex);
  return before.shared && after.shared && across(e, before.edge).segment != across(e, after.edge).segment;
}

const SharedEdge& across(const Engine& e, EdgeId edge) {
  return e.shared.at(e.shared.at(edge.value).partner.value);
}

std::span<const EdgeId> edges_between(const Engine& e, const Segment& a, const Segment& b) {
  const auto entry = e.neighbour_edges.find(pair_key(a.slot, b.slot));
  return entry == e.neighbour_edges.end() ? std::span<const EdgeId>{}
                                          : std::span<const EdgeId>(entry->second);
}

void list_all_pairs(Engine& e) {
  for (const auto& [edge, entry] : e.shared) list_pair(e, {edge});
}

void pair_edges(Engine& e, Segment& of_a, EdgeId a, Segment& of_b, EdgeId b) {
  e.shared[a.value] = {of_a.slot, geometry::kNoSlot, b};
  e.shared[b.value] = {of_b.slot, geometry::kNoSlot, a};
  insert_sorted(of_a.polygon->shared, a);
  insert_sorted(of_b.polygon->shared, b);
  list_pair(e, a);
  of_a.polygon->corners_due.push_back(a);
  of_b.polygon->corners_due.push_back(b);
  for (Segment* s : {&of_a, &of_b}) mark_modified(e, *s);
}

BoundaryChange boundary_changed(Engine& e, Segment& s) {
  PolygonPart& part = *s.polygon;
  BoundaryChange change{part.perimeter.take_removed(), part.perimeter.take_created()};
  for (const auto& [slot, edge] : change.created) {
    part.fresh.emplace_back(slot, edge);
    if (!part.perimeter.alive(slot) || part.perimeter.node(slot).edge != edge ||
        !part.perimeter.node(slot).shared)
      continue;
    SharedEdge& entry = e.shared.at(edge.value);
    entry.slot = slot;
    if (entry.segment == s.slot) continue;
    erase_sorted(e.at(entry.segment).polygon->shared, edge);
    unlist_pair(e, edge);
    entry.segment = s.slot;
    list_pair(e, edge);
    insert_sorted(part.shared, edge);
  }
  // All of them are gone before the first is unshared: none is asked where it ends.
  for (const EdgeId edge : change.removed)
    if (const auto entry = e.shared.find(edge.value); entry != e.shared.end())
      entry->second.slot = geometry::kNoSlot;
  for (const EdgeId edge : change.removed)
    if (e.shared.count(edge.value)) unshare(e, edge);
  return change;
}

void perimeter_changed(Engine& e, Segment& s) {
  BoundaryChange change = boundary_changed(e, s);
  const Places where = places_of(*s.polygon, change.created);
  for (const Box3& place : where.boxes()) s.polygon->box.extend(place);
  description_changed(e, s, where);
  update_index(e, s);
  if (!change.removed.empty())
    e.changes.push_back({Change::Kind::edges_removed, {}, {}, s.id, std::move(change.removed)});
}

void unshare(Engine& e, EdgeId edge) {
  std::vector<EdgeId> going{edge};
  while (!going.empty()) {
    const EdgeId next = going.back();
    going.pop_back();
    const auto entry = e.shared.find(next.value);
    if (entry == e.shared.end()) continue;
    const EdgeId partner = entry->second.partner;
    std::vector<EdgeId> beside;
    adjoining(e, next, beside);
    adjoining(e, partner, beside);
    e.changes.push_back({Change::Kind::unshared,
                         e.at(entry->second.segment).id,
                         e.at(e.shared.at(partner.value).segment).id,
                         {},
                         {next, partner}});
    unlist_pair(e, next);
    forget(e, next);
    forget(e, partner);
    for (const EdgeId b : beside)
      if (e.ends_held > 0)
        e.ends_due.push_back(b);
      else if (e.shared.count(b.value) && !ends_meet(e, b))
        going.push_back(b);
  }
}

void dissolve_neighbours(Engine& e, Segment& a, Segment& b) {
  const auto between = edges_between(e, a, b);
  for (const EdgeId edge : std::vector<EdgeId>(between.begin(), between.end()))
    if (e.shared.count(edge.value)) unshare(e, edge);
}

void dissolve_all_neighbours(Engine& e, Segment& s) {
  while (!s.polygon->shared.empty()) unshare(e, s.polygon->shared.front());
}

void note_ends(Engine& e, std::span<const EdgeId> edges) {
  for (const EdgeId edge : edges) {
    const auto entry = e.shared.find(edge.value);
    if (entry == e.shared.end()) continue;
    e.ends_due.push_back(edge);
    adjoining(e, edge, e.ends_due);
    adjoining(e, entry->second.partner, e.ends_due);
  }
}

void unshare_where_ends_part(Engine& e) {
  for (const EdgeId edge : std::exchange(e.ends_due, {}))
    if (e.shared.count(edge.value) && !ends_meet(e, edge)) unshare(e, edge);
}

std::vector<std::uint32_t> neighbours_across(Engine& e, std::span<const EdgeId> edges) {
  std::vector<std::uint32_t> slots;
  for (const EdgeId edge : edges)
    if (e.shared.count(edge.value)) slots.push_back(across(e, edge).segment);
  std::sort(slots.begin(), slots.end());
  slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
  return slots;
}

void keep_one_concavity(Engine& e, Segment& s, std::span<const EdgeId> edges) {
  const PolygonPart& part = *s.polygon;
  for (const std::uint32_t n : neighbours_across(e, edges)) {
    const auto line = common_line(part.plane(), e.at(n).polygon->plane(), part.box.center());
    if (!line) continue;
    std::array<double, 2> length{};  // of the concave ones, and of the convex
    std::array<std::vector<EdgeId>, 2> kinds;
    for (const EdgeId shared : edges_between(e, s, e.at(n))) {
      const EdgeId edge = s.slot < n ? shared : e.shared.at(shared.value).partner;
      const Slot slot = e.shared.at(edge.value).slot;
      const double along = line->along.dot(part.position(part.perimeter.next(slot)) - part.position(slot));
      length[along > 0] += std::abs(along);
      kinds[along > 0].push_back(edge);
    }
    if (kinds[0].empty() || kinds[1].empty()) continue;
    for (const EdgeId edge : kinds[length[0] > length[1]])
      if (e.shared.count(edge.value)) unshare(e, edge);
  }
}

void perimeter_made_anew(Engine& e, Segment& s) {
  const std::vector<EdgeId> edges = s.polygon->shared;
  for (const EdgeId edge : edges) e.shared.at(edge.value).slot = geometry::kNoSlot;
  s.polygon->fresh.clear();
  boundary_changed(e, s);
  for (const EdgeId edge : edges)
    if (const auto entry = e.shared.find(edge.value);
        entry != e.shared.end() && entry->second.slot == geometry::kNoSlot)
      unshare(e, edge);
}

}  // namespace limpet::model::internal
