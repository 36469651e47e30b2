// Copyright the limpet authors. GPL-3.0-or-later.
#include "surfaces_internal.hpp"

#include <algorithm>
#include <optional>
#include <unordered_map>

namespace limpet::model::internal {

std::uint32_t Surfaces::make_surface() {
  if (free_.empty()) {
    members_.emplace_back();
    return static_cast<std::uint32_t>(members_.size() - 1);
  }
  const std::uint32_t surface = free_.back();
  free_.pop_back();
  return surface;
}

void Surfaces::enter(Slot slot, std::uint32_t surface) {
  if (slot >= place_.size()) place_.resize(slot + std::size_t{1});
  place_[slot] = {surface, static_cast<std::uint32_t>(members_[surface].size())};
  members_[surface].push_back(slot);
}

void Surfaces::leave(Slot slot) {
  const Place place = place_[slot];
  auto& members = members_[place.surface];
  members[place.index] = members.back();
  place_[members.back()].index = place.index;
  members.pop_back();
  place_[slot] = {};
}

/// Removes a surface that has only one member left, or none.
void Surfaces::end_if_alone(std::uint32_t surface) {
  if (members_[surface].size() > 1) return;
  if (!members_[surface].empty()) leave(members_[surface].front());
  members_[surface] = {};
  free_.push_back(surface);
}

void Surfaces::remove(Slot slot) {
  const std::uint32_t surface = surface_of(slot);
  if (surface == kAlone) return;
  leave(slot);
  end_if_alone(surface);
}

void Surfaces::join(Slot a, Slot b) {
  for (const Slot slot : {a, b})
    if (surface_of(slot) == kAlone) enter(slot, make_surface());
  std::uint32_t large = surface_of(a), small = surface_of(b);
  if (large == small) return;
  if (members_[large].size() < members_[small].size()) std::swap(large, small);
  for (const Slot slot : std::exchange(members_[small], {})) enter(slot, large);
  free_.push_back(small);
}

void Surfaces::update(std::span<const std::pair<Slot, Slot>> changed_links, const Relation& relation) {
  std::vector<std::pair<std::uint32_t, Slot>> suspects;  // with their surfaces
  for (const auto& [a, b] : changed_links)
    if (relation.are_neighbours(a, b)) join(a, b);
  for (const auto& [a, b] : changed_links)
    if (!relation.are_neighbours(a, b))
      for (const Slot slot : {a, b})
        if (surface_of(slot) != kAlone) suspects.emplace_back(surface_of(slot), slot);
  std::sort(suspects.begin(), suspects.end());
  suspects.erase(std::unique(suspects.begin(), suspects.end()), suspects.end());
  // Every part of a surface that has come apart contains an end of a removed link.
  std::vector<Slot> of_one;
  for (std::size_t i = 0; i < suspects.size(); ++i) {
    of_one.push_back(suspects[i].second);
    if (i + 1 < suspects.size() && suspects[i + 1].first == suspects[i].first) continue;
    if (of_one.size() > 1) split(of_one, relation);
    of_one.clear();
  }
}

/// Searches that start from several segments of one surface at once.
class Surfaces::Search {
 public:
  Search(std::span<const Slot> starts, const Relation& relation)
      : relation_(relation), active_(starts.size()) {
    for (const Slot start : starts) {
      owner_[start] = parts_.size();
      parts_.push_back({{start}, {start}, 1, parts_.size()});
    }
  }

  /// The next complete part that is separate from the others; nothing when only one search is left.
  std::optional<std::vector<Slot>> next_part() {
    while (active_ > 1) {
      Part& part = least_far();
      if (part.frontier.empty()) {
        --active_;
        part.finished = true;
        return part.seen;
      }
      go_on(part);
    }
    return std::nullopt;
  }

 private:
  struct Part {
    std::vector<Slot> frontier, seen;
    std::size_t work;
    std::size_t merged_into;  ///< itself if it has not been merged
    bool finished = false;
  };

  std::size_t root(std::size_t part) {
    while (parts_[part].merged_into != part)
      part = parts_[part].merged_into = parts_[parts_[part].merged_into].merged_into;
    return part;
  }

  Part& least_far() {
    Part* least = nullptr;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      Part& part = parts_[i];
      if (part.merged_into == i && !part.finished && (!least || part.work < least->work)) least = &part;
    }
    return *least;
  }

  void go_on(Part& part) {
    std::size_t mine = part.merged_into;
    const Slot at = part.frontier.back();
    part.frontier.pop_back();
    neighbours_.clear();
    relation_.add_neighbours(at, neighbours_);
    part.work += neighbours_.size();
    for (const Slot slot : neighbours_) {
      const auto [owner, is_new] = owner_.try_emplace(slot, mine);
      if (is_new) {
        parts_[mine].frontier.push_back(slot);
        parts_[mine].seen.push_back(slot);
      } else if (const std::size_t other = root(owner->second); other != mine) {
        mine = meet(mine, other);
      }
    }
  }

  /// Two parts have met: merges them, and returns the one that goes on.
  std::size_t meet(std::size_t a, std::size_t b) {
    if (parts_[a].seen.size() < parts_[b].seen.size()) std::swap(a, b);
    Part &large = parts_[a], &small = parts_[b];
    large.frontier.insert(large.frontier.end(), small.frontier.begin(), small.frontier.end());
    large.seen.insert(large.seen.end(), small.seen.begin(), small.seen.end());
    large.work += small.work;
    small.merged_into = a;
    small.frontier.clear(), small.seen.clear();
    --active_;
    return a;
  }

  const Relation& relation_;
  std::vector<Part> parts_;
  std::unordered_map<Slot, std::size_t> owner_;
  std::vector<Slot> neighbours_;
  std::size_t active_;
};

void Surfaces::split(std::span<const Slot> suspects, const Relation& relation) {
  const std::uint32_t whole = surface_of(suspects.front());
  Search search(suspects, relation);
  while (const auto part = search.next_part()) {
    for (const Slot slot : *part) leave(slot);
    if (part->size() == 1) continue;
    const std::uint32_t surface = make_surface();
    for (const Slot slot : *part) enter(slot, surface);
  }
  end_if_alone(whole);
}

}  // namespace limpet::model::internal
