// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include <limpet/model/changes.hpp>

#include "complex_internal.hpp"

namespace limpet::model::internal {

/// The segment that each reading went to, if that is asked for (eight bytes per reading).
class Labels {
 public:
  void keep() { kept_ = true; }
  bool kept() const { return kept_; }
  std::size_t size() const { return segments_.size(); }

  /// Adds the label of a new reading, 0 so far. Returns its place, or −1 when labels are not kept.
  std::int64_t add();
  /// Sets the label of a point.
  void set(const RawPoint& raw, SegmentId id) {
    if (kept_ && raw.serial >= 0) segments_[static_cast<std::size_t>(raw.serial)] = id.value;
  }
  /// Follows the mergers among these changes.
  void follow(std::span<const Change>);
  /// For each reading the segment it is in now; 0: in none.
  std::vector<std::uint64_t> settled(const SegmentTable&) const;
  /// When many mergers have been noted, applies them to the labels and forgets them.
  void tidy(const SegmentTable&);

 private:
  friend struct Storage;  // taking apart and putting together (storage_internal.hpp)

  bool kept_ = false;
  std::vector<std::uint64_t> segments_;                       ///< the segment that each reading joined
  std::unordered_map<std::uint64_t, std::uint64_t> goes_to_;  ///< results of mergers since then
};

/// What polygon segments have become by merging (Model::now()).
class Successors {
 public:
  void follow(std::span<const Change>);
  /// The segment that a polygon segment is part of now; none if it has not merged, or its result is gone.
  SegmentId of(SegmentId) const;

 private:
  friend struct Storage;  // taking apart and putting together (storage_internal.hpp)

  /// Segments that have merged into one, with their present segment; `now` 0: an unused entry.
  struct Family {
    std::uint64_t now = 0;
    std::vector<std::uint64_t> members;
  };

  std::uint32_t family_of(std::uint64_t segment);
  void merge(std::uint64_t first, std::uint64_t second, std::uint64_t result);
  void end(std::uint64_t segment);

  std::vector<Family> families_;
  std::vector<std::uint32_t> free_;
  std::unordered_map<std::uint64_t, std::uint32_t> family_;  ///< by segment, past or present
};

}  // namespace limpet::model::internal
