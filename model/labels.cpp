// Copyright the limpet authors. GPL-3.0-or-later.
#include "labels_internal.hpp"

#include <utility>

namespace limpet::model::internal {

std::int64_t Labels::add() {
  if (!kept_) return -1;
  segments_.push_back(0);
  return static_cast<std::int64_t>(segments_.size()) - 1;
}

void Labels::follow(std::span<const Change> changes) {
  if (!kept_) return;
  for (const Change& c : changes)
    if (c.kind == Change::Kind::merged)
      for (const SegmentId id : {c.first, c.second})
        if (id != c.result) goes_to_[id.value] = c.result.value;
}

std::vector<std::uint64_t> Labels::settled(const SegmentTable& segments) const {
  std::unordered_map<std::uint64_t, std::uint64_t> ends;  // where each identity has ended up
  const auto end_of = [&](std::uint64_t id) {
    std::vector<std::uint64_t> way;
    std::uint64_t last = id;
    for (;;) {
      if (const auto known = ends.find(last); known != ends.end()) {
        last = known->second;
        break;
      }
      way.push_back(last);
      const auto next = goes_to_.find(last);
      if (next == goes_to_.end()) {
        last = segments.find({last}) ? last : 0;
        break;
      }
      last = next->second;
    }
    for (const std::uint64_t passed : way) ends[passed] = last;
    return last;
  };
  std::vector<std::uint64_t> result = segments_;
  std::uint64_t before = 0, now = 0;  // successive points are often in one segment
  for (std::uint64_t& label : result) {
    if (label != before) before = label, now = end_of(label);
    label = now;
  }
  return result;
}

void Labels::tidy(const SegmentTable& segments) {
  if (goes_to_.size() < 1024 + segments_.size() / 8) return;
  segments_ = settled(segments);
  goes_to_.clear();
}

void Successors::follow(std::span<const Change> changes) {
  for (const Change& c : changes) {
    // Two polygons merge into a new identity. A segment that merges into one that stays is a point segment,
    // or redundant.
    if (c.kind == Change::Kind::merged)
      c.result == c.first ? end(c.second.value) : merge(c.first.value, c.second.value, c.result.value);
    if (c.kind == Change::Kind::deleted) end(c.first.value);
  }
}

std::uint32_t Successors::family_of(std::uint64_t segment) {
  if (const auto known = family_.find(segment); known != family_.end()) return known->second;
  std::uint32_t family = 0;
  if (free_.empty()) {
    family = static_cast<std::uint32_t>(families_.size());
    families_.emplace_back();
  } else {
    family = free_.back();
    free_.pop_back();
  }
  family_[segment] = family;
  families_[family] = {segment, {segment}};
  return family;
}

void Successors::merge(std::uint64_t first, std::uint64_t second, std::uint64_t result) {
  std::uint32_t large = family_of(first), small = family_of(second);
  if (families_[large].members.size() < families_[small].members.size()) std::swap(large, small);
  for (const std::uint64_t member : std::exchange(families_[small], {}).members) {
    family_[member] = large;
    families_[large].members.push_back(member);
  }
  free_.push_back(small);
  family_[result] = large;
  families_[large].members.push_back(result);
  families_[large].now = result;
}

void Successors::end(std::uint64_t segment) {
  const auto known = family_.find(segment);
  if (known == family_.end()) return;
  const std::uint32_t family = known->second;
  for (const std::uint64_t member : std::exchange(families_[family], {}).members) family_.erase(member);
  free_.push_back(family);
}

SegmentId Successors::of(SegmentId id) const {
  const auto known = family_.find(id.value);
  return known == family_.end() ? SegmentId{} : SegmentId{families_[known->second].now};
}

}  // namespace limpet::model::internal
