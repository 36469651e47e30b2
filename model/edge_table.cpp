// Copyright the limpet authors. GPL-3.0-or-later.
#include "edge_table_internal.hpp"

#include <algorithm>

namespace limpet::model::internal {
namespace {

using geometry::EdgeId;
using geometry::Slot;

std::uint64_t pair_key(std::uint32_t a, std::uint32_t b) {
  return (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
}

}  // namespace

void insert_sorted(std::vector<EdgeId>& edges, EdgeId edge) {
  const auto at = std::lower_bound(edges.begin(), edges.end(), edge);
  if (at == edges.end() || *at != edge) edges.insert(at, edge);
}

void erase_sorted(std::vector<EdgeId>& edges, EdgeId edge) {
  const auto at = std::lower_bound(edges.begin(), edges.end(), edge);
  if (at != edges.end() && *at == edge) edges.erase(at);
}

std::span<const EdgeId> EdgeTable::between(std::uint32_t a, std::uint32_t b) const {
  const auto entry = between_.find(pair_key(a, b));
  return entry == between_.end() ? std::span<const EdgeId>{} : std::span<const EdgeId>(entry->second);
}

void EdgeTable::grow() {
  std::vector<Entry> before(2 * places_.size());
  std::swap(before, places_);
  for (const Entry& entry : before)
    if (entry.edge) places_[index_of(entry.edge)] = entry;
}

std::uint32_t EdgeTable::put(EdgeId edge, std::uint32_t segment, Slot slot) {
  std::size_t i = index_of(edge);
  if (!places_[i].edge) {
    if (2 * (size_ + 1) > places_.size()) grow(), i = index_of(edge);
    places_[i] = {edge, {segment, slot, {}}};
    ++size_;
    return kNowhere;
  }
  EdgePlace& place = places_[i].place;
  place.slot = slot;
  const std::uint32_t before = place.segment;
  if (before == segment) return before;
  const bool listed = bool(place.partner);
  if (listed) unlist(edge);
  place.segment = segment;
  if (listed) list(edge);
  return before;
}

void EdgeTable::erase(EdgeId edge) {
  const std::size_t mask = places_.size() - 1;
  std::size_t hole = index_of(edge);
  if (!places_[hole].edge) return;
  --size_;
  // Later entries of the probe sequence move up into the hole, unless that would put them before their home.
  for (std::size_t i = (hole + 1) & mask; places_[i].edge; i = (i + 1) & mask) {
    if (((i - home(places_[i].edge)) & mask) < ((i - hole) & mask)) continue;
    places_[hole] = places_[i];
    hole = i;
  }
  places_[hole] = {};
}

void EdgeTable::list(EdgeId edge) {
  const EdgePlace &mine = at(edge), &other = at(mine.partner);
  auto& edges = between_[pair_key(mine.segment, other.segment)];
  if (edges.empty()) changed_links_.emplace_back(mine.segment, other.segment);
  insert_sorted(edges, mine.segment < other.segment ? edge : mine.partner);
}

void EdgeTable::unlist(EdgeId edge) {
  const EdgePlace &mine = at(edge), &other = at(mine.partner);
  const auto entry = between_.find(pair_key(mine.segment, other.segment));
  erase_sorted(entry->second, mine.segment < other.segment ? edge : mine.partner);
  if (!entry->second.empty()) return;
  between_.erase(entry);
  changed_links_.emplace_back(mine.segment, other.segment);
}

void EdgeTable::pair(EdgeId a, EdgeId b) {
  find_mutable(a)->partner = b;
  find_mutable(b)->partner = a;
  ++pair_count_;
  list(a);
}

void EdgeTable::unpair(EdgeId edge) {
  unlist(edge);
  EdgePlace* mine = find_mutable(edge);
  find_mutable(mine->partner)->partner = {};
  mine->partner = {};
  --pair_count_;
}

}  // namespace limpet::model::internal
