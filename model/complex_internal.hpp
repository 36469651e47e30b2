// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <limpet/model/changes.hpp>

#include "agenda_internal.hpp"
#include "change_list_internal.hpp"
#include "edge_table_internal.hpp"
#include "segment_table_internal.hpp"
#include "surfaces_internal.hpp"

namespace limpet::model::internal {

/// The edges that an operation on a perimeter has removed, created and moved.
struct BoundaryDifference {
  std::vector<geometry::EdgeId> removed;   ///< edges that are gone
  std::vector<geometry::EdgeId> appeared;  ///< new edges
  std::vector<geometry::EdgeId> moved;     ///< edges with a moved end, or from another segment
  PlacedEdges put;  ///< all edges that were put in place, in the order of the operation

  bool empty() const { return removed.empty() && put.empty(); }
  void clear() { removed.clear(), appeared.clear(), moved.clear(), put.clear(); }
};

struct Portion;
struct Portions;

/// Edits of several perimeters, all of which are made, or none.
struct Transaction {
  std::vector<std::pair<std::uint32_t, geometry::Edit>> edits;  ///< with the slots of their segments
  /// New edges, on the first and on the second of these perimeters, that become corresponding pairs.
  std::vector<std::pair<geometry::EdgeId, geometry::EdgeId>> pairs;
};

/// The polyhedral complex: segments, their perimeters, which edges they share, and the surfaces they form.
///
/// It can be changed only by these member functions. Each keeps the promise of docs/exactness.md, notes on
/// the agenda what is to be looked at because of it, and reports it in changes(). Perimeters change only
/// through change_perimeter(), commit() and replace_perimeter(): the commit protocol (complex_commit.cpp).
class Complex {
 public:
  Complex(const Setting& setting, Agenda& agenda) : setting_(setting), agenda_(agenda), segments_(setting) {}
  Complex(const Complex&) = delete;
  Complex& operator=(const Complex&) = delete;

  // Looking.

  const Setting& setting() const { return setting_; }
  const Rules& rules() const { return setting_.rules(); }
  const SegmentTable& segments() const { return segments_; }
  const SpatialIndex& polygons() const { return segments_.polygons(); }
  const SpatialIndex& points() const { return segments_.points(); }
  const EdgeTable& edges() const { return edges_; }
  const Surfaces& surfaces() const { return surfaces_; }
  const Segment& at(std::uint32_t slot) const { return *segments_.in_slot(slot); }
  /// Null when the slot is free, or no segment has this identity any more.
  const Segment* in_slot(std::uint32_t slot) const { return segments_.in_slot(slot); }
  const Segment* find(SegmentId id) const { return segments_.find(id); }
  /// The segment, if it is still in this slot; else null.
  const Segment* find(SegmentId id, std::uint32_t slot) const {
    const Segment* s = segments_.in_slot(slot);
    return s && s->id == id ? s : nullptr;
  }
  /// The number of sensor points that have come, by which the age of segments is counted.
  std::int64_t now() const { return now_; }
  double modelled_area() const { return modelled_area_; }  ///< of all polygons but initial ones, λ²
  std::int64_t modelled_points() const { return modelled_points_; }  ///< sensor points in all polygons
  std::size_t initial_count() const { return initial_count_; }       ///< of initial segments
  std::uint64_t next_edge() const { return edge_ids_.next(); }
  /// The changes since forget_changes(), in order; complete after settle_changes().
  const std::vector<Change>& changes() const { return changes_.all(); }
  /// Is this a corner vertex: does it join two edges shared with different neighbours?
  bool is_corner(const Segment&, geometry::Slot vertex) const;
  /// The edges that two segments share, as their copies on the segment in the lower slot, ascending. Empty if
  /// they are not neighbours.
  std::span<const geometry::EdgeId> edges_between(const Segment& a, const Segment& b) const {
    return edges_.between(a.slot, b.slot);
  }
  /// The slots of the segments across those of the edges that are shared, each once, ascending.
  std::vector<std::uint32_t> neighbours_across(std::span<const geometry::EdgeId>) const;

  // Segments and their sensor points (complex.cpp).

  void tick() { ++now_; }  ///< one more sensor point has come
  void forget_changes() { changes_.clear(); }
  void settle_changes() { changes_.settle(); }
  /// Brings the surfaces up to date, at the end of a call that changed the model.
  void settle_surfaces();
  const Segment& create_point_segment(const RawPoint&);
  /// Deletes a segment, with its points.
  void remove(const Segment&);
  /// A point joins a polygon, whose perimeter has been extended to it already.
  void absorb(const Segment& into, const RawPoint&);
  /// A reading lies on an initial segment, which it leaves as it is.
  /// A reading has passed the plane of a polygon near it. `through`: for how many that have passed through
  /// the polygon it stands.
  void note_passage(const Segment&, const Eigen::Vector3d& at, std::int64_t through);
  void confirm(const Segment& initial) { ++mutable_of(initial).polygon->confirmed; }
  /// Moves all sensor points of `from` to `into`, and deletes `from`. The plane is not fitted anew.
  void absorb(const Segment& into, const Segment& from, bool stays_young);
  /// The same for two polygons when the perimeter of `into` is already that of both. `into` gets a new
  /// identity.
  void absorb_united(const Segment& into, const Segment& from, bool stays_young);
  void allow_returns();
  /// From now on, what is added to a polygon without a reading is told apart from what was felt (rule
  /// `voids`).
  void keep_felt(const Segment&);
  /// A reading has extended the perimeter to this place; unless finish() is at work, that makes all of it
  /// felt.
  void felt_at(const Segment&, const Eigen::Vector3d&);
  void note_addition(const Segment&);
  void set_fit(const Segment&, const Fit&, std::int64_t next_fit);
  void set_initial_plane(const Segment&, const geometry::Plane&);
  void set_stale(const Segment&, bool stale);
  void reindex(const Segment& s) { segments_.reindex(setting_, mutable_of(s)); }

  // Perimeters (complex_commit.cpp).

  /// Gives this polygon, with new edges, to a new initial segment, or to a point segment.
  const Segment& create_initial(const Fit&, std::unique_ptr<PolygonPart>);
  void become_polygon(const Segment&, std::unique_ptr<PolygonPart>);
  /// Takes `part` away from a mature polygon, by the edit `rest`, which is judged valid, and gives it, with
  /// new edges, to a new segment. Returns that (complex_split.cpp).
  const Segment& split(const Segment&, const geometry::Edit& rest, std::unique_ptr<PolygonPart> part,
                       const Portions&);
  /// Calls `operation(perimeter, edge identities)`, which changes the perimeter or leaves it as it was,
  /// records what it did, and all that follows: `where(difference)` (world) is where the description has
  /// changed. `looked_at`: the edges it puts in place need not be searched for fissures. Returns what it
  /// returned.
  template <class Where, class Operation>
  auto change_perimeter(const Segment& s, bool looked_at, Where&& where, Operation&& operation) {
    auto [answer, difference] = start_change(s, looked_at, operation);
    if (difference.empty())
      spare_ = std::move(difference);
    else
      complete(mutable_of(s), where(std::as_const(difference)), std::move(difference));
    return answer;
  }
  /// The same up to the difference, which is returned with the result: for a merger, of which box,
  /// description and index follow (extend_box(), description_changed(), reindex(), tell()) when all of it is
  /// done.
  template <class Operation>
  auto start_change(const Segment& s, bool looked_at, Operation&& operation) {
    auto answer = operation(mutable_of(s).polygon->perimeter, edge_ids_);
    return std::pair(std::move(answer), book_difference(mutable_of(s), looked_at));
  }
  /// Makes all edits, and updates boxes, descriptions and indices, if every perimeter judges its edit valid.
  /// Otherwise changes nothing, and returns false.
  bool commit(const Transaction&);
  /// The same for edits that have been judged valid already.
  void commit_judged(const Transaction&);
  /// A polygon's description has changed in `where` (world).
  void description_changed(const Segment&, const DirtyRegion& where);
  /// Extends a polygon's box by these places.
  void extend_box(const Segment&, const DirtyRegion& where);
  /// Reports the difference in changes().
  void tell(const Segment&, BoundaryDifference&&);
  /// Puts a polygon on a new chart, where its perimeter and its published plane are these. Edges keep their
  /// identities, or are removed.
  void replace_perimeter(const Segment&, const geometry::Chart&, geometry::Polygon&&, const geometry::Plane&);
  /// Sets the plane that the perimeter is lifted to.
  void set_plane(const Segment&, const geometry::Lift&, const Eigen::Vector3d& outward);
  /// After set_plane() or replace_perimeter(): updates box, description and index, and reports all edges as
  /// moved.
  void plane_moved(const Segment&);
  /// The source of identities, for new edges that are on no segment yet.
  geometry::EdgeIds& edge_ids() { return edge_ids_; }

  // Shared edges (complex_pairs.cpp; thesis §2.2, §2.8).

  void tell_shared(const Segment& a, const Segment& b, geometry::EdgeId, geometry::EdgeId);
  /// Makes two open edges, as they lie, a corresponding pair. Precondition: they are on different segments,
  /// lie on the line where the two planes meet, to the rounding, and run opposite to each other between the
  /// same ends.
  void share_open(geometry::EdgeId, geometry::EdgeId);
  void tell_corner(const Segment& a, const Segment& b, std::span<const geometry::EdgeId> edges);
  /// Unshares edges whose ends are not in place any more after this transaction: one may have moved the far
  /// end of an edge that ends at a corner beside its line, so that it does not run on there.
  void keep_ends_in_place(const Transaction&);
  /// Unsharing (§2.8): both copies become open edges. If the ends of the copies of an adjoining shared edge
  /// no longer coincide because of it, that edge is unshared, too.
  void unshare(geometry::EdgeId);
  /// Unshares all edges that the two share.
  void dissolve_neighbours(const Segment&, const Segment&);
  void dissolve_all_neighbours(const Segment&);
  /// Within with_ends_apart(): the ends of these edges, and of those that adjoin their copies, are to be
  /// checked at the end.
  void note_ends(std::span<const geometry::EdgeId>);
  /// Calls `change`, during which the two copies of a shared edge need not coincide, because planes move or
  /// edges change their segments. Unsharing checks no adjoining edges meanwhile; all that are concerned are
  /// checked at the end of the outermost call.
  template <class F>
  void with_ends_apart(F&& change) {
    ++ends_held_;
    change();
    if (--ends_held_ == 0) unshare_where_ends_part();
  }

 private:
  friend struct Storage;  // taking apart and putting together (storage_internal.hpp)

  Segment& mutable_of(const Segment& s) { return *segments_.in_slot(s.slot); }
  BoundaryDifference book_difference(Segment&, bool looked_at);
  void book_put_edges(Segment&, BoundaryDifference&);
  void book_removed_edges(std::vector<geometry::EdgeId>& removed);
  void complete(Segment&, const DirtyRegion& where, BoundaryDifference&&);
  void perimeter_changed(Segment&, std::span<const geometry::EdgeId> born);
  void count_area(PolygonPart&);
  void forget_points(Segment&);
  void become_mature(Segment&);
  void absorb_data(Segment& into, const Segment& from, bool stays_young);
  std::vector<geometry::EdgeId> erase(Segment&);
  void take_portion(Segment&, const Portion&);
  void make_open(geometry::EdgeId);
  void mark_shared(Segment&, geometry::Slot edge, bool shared);
  bool runs_on(const Segment&, geometry::Slot corner) const;
  bool end_in_place(const Segment&, geometry::Slot vertex, const geometry::Plane& across) const;
  bool ends_meet(geometry::EdgeId) const;
  void add_adjoining(geometry::EdgeId, std::vector<geometry::EdgeId>& result) const;
  void unshare_where_ends_part();

  const Setting& setting_;
  Agenda& agenda_;
  SegmentTable segments_;
  EdgeTable edges_;
  Surfaces surfaces_;
  geometry::EdgeIds edge_ids_;
  std::int64_t now_ = 0;
  double modelled_area_ = 0;
  std::int64_t modelled_points_ = 0;
  std::size_t initial_count_ = 0;
  int ends_held_ = 0;                       ///< see with_ends_apart()
  std::vector<geometry::EdgeId> ends_due_;  ///< shared edges whose ends are to be checked then
  BoundaryDifference spare_;                ///< empty; its memory is for the next one
  ChangeList changes_;
};

/// All surfaces, each in ascending order, ordered by their lowest identity. A segment without neighbours is a
/// surface of its own.
std::vector<std::vector<SegmentId>> surfaces_of(const Complex&);

/// The polygons in these slots for which has_turn(segment) is true, each once, by identity. As some may merge
/// while the list is gone through, check each with find() first.
using Turn = std::vector<std::pair<SegmentId, std::uint32_t>>;
template <class Slots, class F>
Turn polygons_of(const Complex& complex, const Slots& slots, F&& has_turn) {
  Turn turn;
  for (const std::uint32_t slot : slots)
    if (const Segment* s = complex.in_slot(slot); s && s->polygon && has_turn(*s))
      turn.emplace_back(s->id, slot);
  std::sort(turn.begin(), turn.end());
  turn.erase(std::unique(turn.begin(), turn.end()), turn.end());
  return turn;
}
/// The polygon segments near these places, except the one in slot `but`, by identity.
Turn polygons_near(const Complex&, const DirtyRegion&, std::uint32_t but);

}  // namespace limpet::model::internal
