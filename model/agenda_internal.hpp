// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "dirty_region_internal.hpp"
#include "owned_internal.hpp"
#include "segment_internal.hpp"
#include "thresholds_internal.hpp"

namespace limpet::model::internal {

/// Two slots, the lower one first.
using SlotPair = std::pair<std::uint32_t, std::uint32_t>;
/// Two segments, the one of lower identity first.
using SegmentPair = std::pair<SegmentId, SegmentId>;

/// How far steps 4 and 5 go.
struct SharingReach {
  double section =
      kSectionReach;  ///< λ: how far a section that gives way to a shared edge may be from its line
  double least = kLeastNeighbours;  ///< λ: no shorter edge makes two segments neighbours
  bool from_shared = false;         ///< sections are looked for beside edges that the two share already, too
};

/// What of a polygon is to be looked at.
struct PolygonDue {
  DirtyRegion changed;   ///< dirty regions: where its description has changed since step 2 saw it
  DirtyRegion unshared;  ///< the same for step 4
  PlacedEdges fresh;     ///< edges that step 3 has not looked at for fissures
  std::vector<geometry::EdgeId> corners_due;  ///< shared edges that step 5 has not seen
  std::int64_t next_share = 0;                ///< count of its points at which step 4 looks at it again
  bool shared_later = false;                  ///< it waits in Agenda::share_later
};

/// All worklists of the update procedure (thesis §2.3): what is to be looked at next, and why. Segments are
/// named by their slots: a slot in a list may hold another segment by now, or none.
class Agenda {
 public:
  /// Are neighbours asked for?
  explicit Agenda(bool neighbours) : neighbours_(neighbours) {}

  // A segment comes and goes. Lists of slots are not searched.
  void opened(std::uint32_t slot);
  void became_polygon(std::uint32_t slot);
  void closed(std::uint32_t slot) { due_[slot] = {}; }

  /// Step 2 onwards is to look at the segment (thesis §2.3: it is flagged).
  void mark_modified(std::uint32_t slot) {
    if (std::exchange(due_[slot].modified, true)) return;
    modified_.push_back(slot);
    if (neighbours_) to_share_.push_back(slot);
  }
  /// The slots whose flag was set, in that order.
  const std::vector<std::uint32_t>& modified() const { return modified_; }
  void clear_modified();

  /// A polygon's description changed in `where` (world).
  void description_changed(std::uint32_t slot, const DirtyRegion& where, bool young);
  /// Step 4 is to look at a polygon there once more.
  void look_for_neighbours(std::uint32_t slot, const DirtyRegion& where) {
    if (neighbours_) polygon(slot).unshared.add(where);
  }
  PolygonDue& polygon(std::uint32_t slot) { return *due_[slot].polygon; }
  const PolygonDue& polygon(std::uint32_t slot) const { return *due_[slot].polygon; }
  /// How many points of a young segment have been tried on mature polygons.
  std::size_t& seen(std::uint32_t slot) { return due_[slot].seen; }

  /// Step 4: slots that were modified since it was last taken, as far as they have their turn now; the others
  /// wait until some later set.
  std::vector<std::uint32_t> take_to_share();
  void wait_to_share(std::uint32_t slot);
  /// A look at two polygons is due, and where.
  DirtyRegion& look_due(SlotPair pair) { return looks_due_[pair]; }
  bool looks_due() const { return !looks_due_.empty(); }
  std::pair<SlotPair, DirtyRegion> take_look();
  /// How many looks the next set may take, when so many sensor points have come in all.
  std::int64_t looks_for(std::int64_t points);

  /// The geometry refused to merge two polygons whose descriptions were of these numbers: not tried again
  /// until one has changed.
  void remember_refusal(SegmentPair pair, std::pair<std::uint64_t, std::uint64_t> shapes);
  bool remembered_as_refused(SegmentPair pair, std::pair<std::uint64_t, std::uint64_t> shapes) const;
  std::size_t refusals() const { return refused_.size(); }
  template <class F>
  void forget_refusals(F&& goes) {
    std::erase_if(refused_, [&](const auto& entry) { return goes(entry.first); });
  }

  /// Edges of the two were in disorder: no further ones are formed before the next set (thesis §2.6).
  void note_disorder(SegmentId a, SegmentId b) { disordered_.insert(std::minmax(a, b)); }
  bool in_disorder(SegmentId a, SegmentId b) const { return disordered_.count(std::minmax(a, b)) > 0; }
  void forget_disorder() { disordered_.clear(); }

  /// Step 4 found the segment redundant (thesis §2.9): to be deleted behind it.
  void note_redundant(SegmentId id) { redundant_.push_back(id); }
  std::vector<SegmentId> take_redundant() { return std::exchange(redundant_, {}); }

  /// A point segment grew, when so many sensor points had come: some time after, ask whether it expires.
  void note_age(SegmentId id, std::int64_t now) { by_age_.emplace_back(now, id); }
  /// The next segment that grew before then, and when; each once for every time it grew.
  std::optional<std::pair<std::int64_t, SegmentId>> take_aged(std::int64_t before);

  bool finishing = false;  ///< no more readings are expected: nothing is put off
  SharingReach sharing;

 private:
  friend struct Storage;  // taking apart and putting together (storage_internal.hpp)

  struct Due {
    bool modified = false;
    std::size_t seen = 0;
    Owned<PolygonDue> polygon;
  };

  bool neighbours_;
  std::vector<Due> due_;  ///< by slot
  std::vector<std::uint32_t> modified_, to_share_;
  std::deque<std::uint32_t> share_later_;
  std::map<SlotPair, DirtyRegion> looks_due_;
  SlotPair last_look_{};
  std::int64_t looked_at_ = 0;  ///< how many sensor points had come when the last set took its looks
  std::map<SegmentPair, std::pair<std::uint64_t, std::uint64_t>> refused_;
  std::set<SegmentPair> disordered_;
  std::vector<SegmentId> redundant_;
  std::deque<std::pair<std::int64_t, SegmentId>> by_age_;
};

}  // namespace limpet::model::internal
