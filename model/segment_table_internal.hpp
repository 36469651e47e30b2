// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <memory>
#include <unordered_map>
#include <vector>

#include "segment_internal.hpp"
#include "setting_internal.hpp"

namespace limpet::model::internal {

/// All segments: by slot, by identity, and by place.
///
/// Invariant: identities ascend and are never reused; a segment that has been reindexed is in the spatial
/// index of its kind, with a box that reaches at least λ beyond it.
class SegmentTable {
 public:
  explicit SegmentTable(const Setting&);

  std::uint32_t slot_count() const { return static_cast<std::uint32_t>(segments_.size()); }
  std::size_t size() const { return slot_of_.size(); }
  /// Null when the slot is free.
  const Segment* in_slot(std::uint32_t slot) const { return segments_[slot].get(); }
  Segment* in_slot(std::uint32_t slot) { return segments_[slot].get(); }
  const Segment* find(SegmentId) const;
  template <class F>
  void for_each(F&& f) const {
    for (const auto& s : segments_)
      if (s) f(*s);
  }
  /// Spatial indices of polygon and of point segments, by their boxes enlarged by λ and some slack.
  const SpatialIndex& polygons() const { return polygons_; }
  const SpatialIndex& points() const { return points_; }

  /// Makes an empty segment with a new identity, in a free slot. It is in no index yet.
  Segment& create();
  void erase(Segment&);
  /// Gives it a new identity.
  void rename(Segment&);
  /// Brings the segment's box in the spatial index up to date.
  void reindex(const Setting&, Segment&);

 private:
  friend struct Storage;  // taking apart and putting together (storage_internal.hpp)

  SpatialIndex& index_of(const Segment& s) { return s.indexed_as_polygon ? polygons_ : points_; }
  void remove_from_index(Segment&);

  std::uint64_t next_id_ = 1;
  std::vector<std::unique_ptr<Segment>> segments_;  ///< by slot
  std::vector<std::uint32_t> free_;                 ///< free slots; the last one is taken next
  std::unordered_map<std::uint64_t, std::uint32_t> slot_of_;
  SpatialIndex polygons_, points_;
};

}  // namespace limpet::model::internal
