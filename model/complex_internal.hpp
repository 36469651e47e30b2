// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

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

/// What an operation has done to a perimeter.
struct BoundaryDifference {
  std::vector<geometry::EdgeId> removed;   ///< identities that went
  std::vector<geometry::EdgeId> appeared;  ///< identities that came
  std::vector<geometry::EdgeId>
      moved;        ///< edges that kept theirs, with an end elsewhere or on another segment
  PlacedEdges put;  ///< all edges that were put in place, in this order
};

/// Edits of several perimeters that are made together, or not at all.
struct Transaction {
  std::vector<std::pair<std::uint32_t, geometry::Edit>> edits;  ///< with the slots of their segments
  /// New edges on the first and the second of these perimeters that are a corresponding pair from then on.
  std::vector<std::pair<geometry::EdgeId, geometry::EdgeId>> pairs;
};

/// The polyhedral complex: segments, their perimeters, which edges they share, and the surfaces they form.
///
/// Who has a constant one may look; who has one to change can do so only by what stands here, each of which
/// leaves the promise of docs/exactness.md intact, notes on the agenda what is to be looked at because of it,
/// and tells it in changes(). Perimeters change by change_perimeter(), commit() and replace_perimeter()
/// alone: these are the commit protocol (complex_commit.cpp).
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
  /// Nothing when there is none in that slot, or of that identity, any more.
  const Segment* in_slot(std::uint32_t slot) const { return segments_.in_slot(slot); }
  const Segment* find(SegmentId id) const { return segments_.find(id); }
  /// The segment if it is still in the slot it was in.
  const Segment* find(SegmentId id, std::uint32_t slot) const {
    const Segment* s = segments_.in_slot(slot);
    return s && s->id == id ? s : nullptr;
  }
  /// How many sensor points have come: the clock by which segments age.
  std::int64_t now() const { return now_; }
  double modelled_area() const { return modelled_area_; }            ///< of all polygons, λ²
  std::int64_t modelled_points() const { return modelled_points_; }  ///< in all polygons
  std::uint64_t next_edge() const { return edge_ids_.next(); }
  /// What has been done since forget_changes(), in order, once it has been settled.
  const std::vector<Change>& changes() const { return changes_.all(); }
  /// Does a vertex join two edges that are shared with different neighbours?
  bool is_corner(const Segment&, geometry::Slot vertex) const;
  /// The edges that two segments share: the copies on the one in the lower slot. Empty if they are no
  /// neighbours.
  std::span<const geometry::EdgeId> edges_between(const Segment& a, const Segment& b) const {
    return edges_.between(a.slot, b.slot);
  }
  /// The slots of the segments across these edges, as far as they are shared, ascending.
  std::vector<std::uint32_t> neighbours_across(std::span<const geometry::EdgeId>) const;

  // Sensor points and what is known of them (complex.cpp).

  void tick() { ++now_; }  ///< one more sensor point has come
  void forget_changes() { changes_.clear(); }
  void settle_changes() { changes_.settle(); }
  /// Brings the surfaces up to date: after a call that changed the model, before it is read.
  void settle_surfaces();
  const Segment& create_point_segment(const RawPoint&);
  /// Takes a segment away, with its points.
  void remove(const Segment&);
  /// A point joins a segment; its perimeter has been extended to it.
  void absorb(const Segment& into, const RawPoint&);
  /// All sensor points of `from` become those of `into`, and `from` is gone. The plane is not fitted anew.
  void absorb(const Segment& into, const Segment& from, bool stays_young);
  /// The same of two polygons when the perimeter of `into` is that of both already: what came of them gets a
  /// new identity.
  void absorb_united(const Segment& into, const Segment& from, bool stays_young);
  void allow_returns();
  void set_fit(const Segment&, const Fit&, std::int64_t next_fit);
  void set_initial_plane(const Segment&, const geometry::Plane&);
  void set_stale(const Segment&, bool stale);
  void reindex(const Segment& s) { segments_.reindex(setting_, mutable_of(s)); }

  // Perimeters (complex_commit.cpp).

  /// A new segment known beforehand, or a point segment, has this polygon from now on; its edges are new.
  const Segment& create_initial(const Fit&, std::unique_ptr<PolygonPart>);
  void become_polygon(const Segment&, std::unique_ptr<PolygonPart>);
  /// Does `operation(perimeter, edge identities)`, which changes the perimeter or leaves it as it was, and
  /// books what it has done. Returns its answer and the difference. `looked_at`: the edges it puts in place
  /// need no look for fissures.
  template <class Operation>
  auto change_perimeter(const Segment& s, bool looked_at, Operation&& operation) {
    auto answer = operation(mutable_of(s).polygon->perimeter, edge_ids_);
    return std::pair(std::move(answer), book_difference(mutable_of(s), looked_at));
  }
  /// Makes all of the edits if every perimeter judges its own valid. Then boxes, descriptions and indices
  /// follow. Otherwise nothing has changed.
  bool commit(const Transaction&);
  /// For edits that have been judged already.
  void commit_judged(const Transaction&);
  /// A polygon's description has changed in `where` (world).
  void description_changed(const Segment&, const DirtyRegion& where);
  /// Its box holds these places, too.
  void extend_box(const Segment&, const DirtyRegion& where);
  /// Names the edges that went, came and moved.
  void tell(const Segment&, BoundaryDifference&&);
  /// A new chart: the same perimeter, on it, and the plane. Edges keep their identities, or go.
  void replace_perimeter(const Segment&, const geometry::Chart&, geometry::Polygon&&, const geometry::Plane&);
  /// The plane that the perimeter is lifted to.
  void set_plane(const Segment&, const geometry::Lift&, const Eigen::Vector3d& outward);
  /// All vertices have moved with the plane: box, description and index follow.
  void plane_moved(const Segment&);
  /// Identities for edges that are on no segment yet.
  geometry::EdgeIds& edge_ids() { return edge_ids_; }

  // Who shares what (complex_pairs.cpp; thesis §2.2, §2.8).

  void tell_shared(const Segment& a, const Segment& b, geometry::EdgeId, geometry::EdgeId);
  void tell_corner(const Segment& a, const Segment& b, std::span<const geometry::EdgeId> edges);
  /// Unsharing (§2.8): both copies become open edges. Where that leaves the copies of another shared edge
  /// with ends apart, that edge goes the same way.
  void unshare(geometry::EdgeId);
  /// The two are no neighbours any more.
  void dissolve_neighbours(const Segment&, const Segment&);
  void dissolve_all_neighbours(const Segment&);
  /// Notes these edges, and those that adjoin their copies, to be looked at when ends meet again.
  void note_ends(std::span<const geometry::EdgeId>);
  /// Does something that leaves the ends of copies apart for the moment: planes move, edges change hands.
  /// What is unshared meanwhile asks nothing of its neighbours' ends; in the end all concerned are looked at.
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
  void perimeter_changed(Segment&, std::span<const geometry::EdgeId> born);
  void count_area(PolygonPart&);
  void forget_points(Segment&);
  void absorb_data(Segment& into, const Segment& from, bool stays_young);
  std::vector<geometry::EdgeId> erase(Segment&);
  void make_open(geometry::EdgeId);
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
  int ends_held_ = 0;                       ///< see with_ends_apart()
  std::vector<geometry::EdgeId> ends_due_;  ///< shared edges whose ends are to be looked at then
  BoundaryDifference spare_;                ///< empty; keeps its memory for the next one
  ChangeList changes_;
};

/// All surfaces, each ascending, in the order of their lowest identity; a segment without neighbours is one.
std::vector<std::vector<SegmentId>> surfaces_of(const Complex&);

/// Of the segments in these slots the polygons that `has_turn`, each once, by identity. What they merge into
/// is not among them: ask find() before each.
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
/// The polygon segments near these places, but for the one in this slot, by identity.
Turn polygons_near(const Complex&, const DirtyRegion&, std::uint32_t but);

}  // namespace limpet::model::internal
