// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "dirty_region_internal.hpp"
#include "owned_internal.hpp"
#include "segment_internal.hpp"
#include "setting_internal.hpp"
#include "thresholds_internal.hpp"

namespace limpet::model::internal {

/// Two slots, the lower one first.
using SlotPair = std::pair<std::uint32_t, std::uint32_t>;
/// Two segments, the one of lower identity first.
using SegmentPair = std::pair<SegmentId, SegmentId>;

/// How far steps 4 and 5 of the update search.
struct SharingReach {
  double section = kSectionReach;   ///< λ: greatest distance of a section from the line of its shared edge
  double least = kLeastNeighbours;  ///< λ: shortest edge that makes two segments neighbours
  bool from_shared = false;         ///< sections may also consist of edges that the two share already

  /// The cosine of the least angle between two planes that share edges: μ. At the end of input polygons that
  /// are still two, as noise or tolerance tell them apart, meet in a line from half of that on (rule
  /// `bends`).
  double most_cosine(const Setting& setting) const {
    return section > 1 && setting.rules().bends ? setting.cos_half_angle : setting.cos_angle;
  }

  /// How far a perimeter may reach beyond a line of two planes that meet at an angle of this sine, and give
  /// way to it without more, scan's unit: λ; and at the end of input, as readings within the tolerance of
  /// both planes go to either of them, farther where they meet at a small angle: two planes of one surface
  /// are within twice the tolerance of each other.
  double at_angle(double lambda, double tolerance, double sine) const {
    if (section <= 1) return lambda;
    return std::min(lambda + 2 * tolerance * (1 / sine - 1), section * lambda);
  }
};

/// The worklists of one polygon.
struct PolygonDue {
  DirtyRegion changed;                        ///< where its description has changed since step 2 looked at it
  DirtyRegion unshared;                       ///< the same since step 4 looked at it
  PlacedEdges fresh;                          ///< edges that step 3 has not searched for fissures yet
  std::vector<geometry::EdgeId> corners_due;  ///< shared edges that step 5 has not looked at yet
  std::int64_t next_share = 0;                ///< number of its points at which step 4 looks at it again
  bool shared_later = false;                  ///< it waits in Agenda::share_later
  std::uint64_t no_pinch = 0;  ///< PolygonPart::shape that was last looked at for pinches, in vain
};

/// All worklists of the update procedure (thesis §2.3): what is to be looked at next, and why. Lists name
/// segments by their slots, which may be free, or hold other segments, by the time the list is taken.
class Agenda {
 public:
  /// `neighbours`: are shared edges formed at all (Parameters::neighbours)?
  explicit Agenda(bool neighbours) : neighbours_(neighbours) {}

  // A segment comes, becomes a polygon, or goes. Lists that name its slot are left as they are.
  void opened(std::uint32_t slot);
  void became_polygon(std::uint32_t slot);
  void closed(std::uint32_t slot) { due_[slot] = {}; }

  /// Flags the segment (thesis §2.3), for steps 2 to 5 to look at.
  void mark_modified(std::uint32_t slot) {
    if (!std::exchange(due_[slot].modified, true)) list_modified(slot);
  }
  /// The flagged slots, in the order in which they were flagged.
  const std::vector<std::uint32_t>& modified() const { return modified_; }
  void clear_modified();

  /// A polygon's description changed in `where` (world).
  void description_changed(std::uint32_t slot, const DirtyRegion& where, bool young);
  /// Step 4 is to look at a polygon again, at these places (world).
  void look_for_neighbours(std::uint32_t slot, const DirtyRegion& where) {
    if (neighbours_) polygon(slot).unshared.add(where);
  }
  PolygonDue& polygon(std::uint32_t slot) { return *due_[slot].polygon; }
  const PolygonDue& polygon(std::uint32_t slot) const { return *due_[slot].polygon; }
  /// How many points of a young segment, from the first on, have been tried on mature polygons.
  std::size_t& seen(std::uint32_t slot) { return due_[slot].seen; }

  /// Step 4: takes the slots modified since the last call, and the next kWaitingSeen of those that wait. The
  /// caller sends those that are not due back to wait_to_share(). Valid until the next call.
  const std::vector<std::uint32_t>& take_to_share();
  void wait_to_share(std::uint32_t slot);
  /// The places (world) where a look at two polygons is due, to be added to.
  DirtyRegion& look_due(SlotPair pair) { return looks_due_[pair]; }
  bool looks_due() const { return !looks_due_.empty(); }
  std::pair<SlotPair, DirtyRegion> take_look();
  /// How many looks this set may take, after `points` sensor points in all. To be called once per set.
  std::int64_t looks_for(std::int64_t points);

  /// Remembers that two polygons could not be merged while their descriptions had these version numbers
  /// (PolygonPart::shape), so that they are not tried again until one of them has changed.
  void remember_refusal(SegmentPair pair, std::pair<std::uint64_t, std::uint64_t> shapes);
  bool remembered_as_refused(SegmentPair pair, std::pair<std::uint64_t, std::uint64_t> shapes) const;
  std::size_t refusals() const { return refused_.size(); }
  template <class F>
  void forget_refusals(F&& goes) {
    std::erase_if(refused_, [&](const auto& entry) { return goes(entry.first); });
  }

  /// Edges that the two shared broke an ordering: they form no others before the next set (thesis §2.6).
  void note_disorder(SegmentId a, SegmentId b) { disordered_.insert(std::minmax(a, b)); }
  bool in_disorder(SegmentId a, SegmentId b) const { return disordered_.count(std::minmax(a, b)) > 0; }
  void forget_disorder() { disordered_.clear(); }

  /// Step 4 found the segment redundant (thesis §2.9); it is deleted after step 5.
  void note_redundant(SegmentId id) { redundant_.push_back(id); }
  std::vector<SegmentId> take_redundant() { return std::exchange(redundant_, {}); }

  /// So many readings have passed through the polygon that it is no surface.
  void note_passed(SegmentId id) { passed_.push_back(id); }
  std::vector<SegmentId> take_passed() { return std::exchange(passed_, {}); }

  /// finish() has cut a polygon in two here (world); its parts do not merge until it ends (rule `pinches`).
  void note_parting(const Eigen::Vector3d& at) { partings_.push_back(at); }
  const std::vector<Eigen::Vector3d>& partings() const { return partings_; }
  void forget_partings() { partings_.clear(); }

  /// A point segment grew when `now` sensor points had come; later it is asked whether it expires.
  void note_age(SegmentId id, std::int64_t now) { by_age_.emplace_back(now, id); }
  /// The next entry of note_age() from before then. A segment comes up once for every time it grew.
  std::optional<std::pair<std::int64_t, SegmentId>> take_aged(std::int64_t before);

  bool finishing = false;  ///< during finish(): nothing is put off until later sets
  /// Is finish() to end early? Loops over segments ask it before each one; what they leave is taken up again
  /// by the next finish().
  bool stopped() const { return stop && stop(); }
  std::function<bool()> stop;  ///< only during finish()
  SharingReach sharing;

 private:
  friend struct Storage;  // taking apart and putting together (storage_internal.hpp)

  struct Due {
    bool modified = false;
    std::size_t seen = 0;
    Owned<PolygonDue> polygon;
  };

  void list_modified(std::uint32_t slot);

  bool neighbours_;
  std::vector<Due> due_;  ///< by slot
  std::vector<std::uint32_t> modified_, to_share_;
  std::vector<std::uint32_t> taken_;  ///< what take_to_share() returned last; its memory serves the next one
  std::deque<std::uint32_t> share_later_;
  std::map<SlotPair, DirtyRegion> looks_due_;
  SlotPair last_look_{};
  std::int64_t looked_at_ = 0;  ///< sensor points that had come at the last looks_for()
  std::map<SegmentPair, std::pair<std::uint64_t, std::uint64_t>> refused_;
  std::set<SegmentPair> disordered_;
  std::vector<Eigen::Vector3d> partings_;  ///< only during finish()
  std::vector<SegmentId> redundant_, passed_;
  std::deque<std::pair<std::int64_t, SegmentId>> by_age_;
};

}  // namespace limpet::model::internal
