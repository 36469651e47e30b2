// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include <limpet/model/changes.hpp>

#include "complex_internal.hpp"

namespace limpet::model::internal {

/// Which segment each sensor point went to, once that is asked for (eight bytes a point).
class Labels {
 public:
  void keep() { kept_ = true; }
  bool kept() const { return kept_; }
  std::size_t size() const { return segments_.size(); }

  /// Another reading has come, and is nowhere yet. Returns its place; −1 where labels are not kept.
  std::int64_t add();
  /// The point is in this segment now.
  void set(const RawPoint&, SegmentId);
  /// Points of segments that merged go with them.
  void follow(std::span<const Change>);
  /// For each point the segment it is in now; 0: nowhere.
  std::vector<std::uint64_t> settled(const SegmentTable&) const;
  /// Forgets mergers, when they are many, by writing the labels anew.
  void tidy(const SegmentTable&);

 private:
  friend struct Storage;  // taking apart and putting together (storage_internal.hpp)

  bool kept_ = false;
  std::vector<std::uint64_t> segments_;                       ///< that each point joined
  std::unordered_map<std::uint64_t, std::uint64_t> goes_to_;  ///< segments that merged since
};

/// What became of polygon segments that merged (Model::now()).
class Successors {
 public:
  void follow(std::span<const Change>);
  /// The segment that a polygon segment is part of now; none when it is not known.
  SegmentId of(SegmentId) const;

 private:
  friend struct Storage;  // taking apart and putting together (storage_internal.hpp)

  /// Those that have become one, with the segment they are now; 0: the number is free.
  struct Family {
    std::uint64_t now = 0;
    std::vector<std::uint64_t> members;
  };

  std::uint32_t family_of(std::uint64_t segment);
  void merge(std::uint64_t first, std::uint64_t second, std::uint64_t result);
  void end(std::uint64_t segment);

  std::vector<Family> families_;
  std::vector<std::uint32_t> free_;
  std::unordered_map<std::uint64_t, std::uint32_t> family_;  ///< by segment, past and present ones
};

}  // namespace limpet::model::internal
