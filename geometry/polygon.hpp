// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include <limpet/geometry/edge_index.hpp>
#include <limpet/geometry/types.hpp>

namespace limpet::geometry {

/// A vertex of a boundary that is yet to be made, and the edge that leaves it.
struct NewVertex {
  Point2 at;
  EdgeId edge{};        ///< the identity the edge keeps; none: it gets a new one
  bool shared = false;  ///< the edge is a shared edge
};

/// A chain of new edges, from -> via[0] -> ... -> to, between two vertices that stay.
struct Chain {
  Slot from = kNoSlot;
  std::vector<NewVertex> via;
  Slot to = kNoSlot;
  EdgeId edge{};        ///< the identity that the new edge from `from` keeps; none: it gets a new one
  bool shared = false;  ///< that edge is a shared edge
};

/// A candidate change of a polygon's boundary. Behind each chain's `from` the old boundary is removed, in its
/// direction, as far as the first vertex that is the `to` of any chain; where that is another chain's, cycles
/// are joined or split. Whole cycles may be removed, and new ones (loops) added. judge() judges it; it is
/// then committed whole or dropped.
struct Edit {
  std::vector<Chain> chains;
  std::vector<std::vector<NewVertex>> loops;
  std::vector<CycleId> removed_cycles;
};

/// Why the judge refused a candidate.
enum class Verdict {
  valid,
  degenerate_edge,  ///< an edge without length
  crossing,         ///< two edges meet other than consecutive ones at their common vertex
  swept_vertex,     ///< a vertex that stays lies in the region that changes sides
  orientation,  ///< a cycle turns the wrong way, there is not one outer cycle, or parts of the edit overlap
  too_few_vertices,  ///< a cycle with fewer than three vertices
  shrinking,         ///< from grow() only: less area would be gained than asked for
};
const char* to_string(Verdict);

struct PolygonState;

/// A planar polygon: one outer perimeter (anticlockwise) and any number of hole perimeters (clockwise), so
/// that the inside is always on the left of an edge.
///
/// Invariant (kept by every edit that judge() accepts): the cycles are simple and disjoint, that is, no two
/// edges meet except consecutive ones at their common vertex; holes lie inside the outer perimeter and
/// outside each other.
///
/// Const member functions change nothing, not even a cache: any number of threads may call them at the same
/// time, as long as none calls one that is not const.
class Polygon {
 public:
  enum class Side { outside, boundary, inside };

  struct Node {
    Point2 at;
    Slot next = kNoSlot, prev = kNoSlot;
    CycleId cycle{};
    EdgeId edge{};  ///< none: the slot is free
    bool shared = false;
  };
  struct Cycle {
    Slot first = kNoSlot;
    std::uint32_t size = 0;  ///< vertices; 0: the cycle is free
    bool hole = false;
  };

  Polygon() = default;

  /// The polygon that had this state(): every later operation gives the same bits as on the original. Throws
  /// std::invalid_argument, with the reason, when the state is inconsistent or the polygon is not valid.
  static Polygon from_state(PolygonState);
  PolygonState state() const;

  /// The polygon with these cycles, outer first, or nothing when they are not valid (see the invariant).
  static std::optional<Polygon> from_cycles(std::span<const std::vector<NewVertex>> cycles, EdgeIds& ids);

  const Node& node(Slot s) const { return nodes_[static_cast<std::uint32_t>(s)]; }
  Point2 at(Slot s) const { return node(s).at; }
  Slot next(Slot s) const { return node(s).next; }
  Slot prev(Slot s) const { return node(s).prev; }
  Point2 end(Slot s) const { return at(next(s)); }
  bool alive(Slot s) const { return static_cast<std::uint32_t>(s) < nodes_.size() && bool(node(s).edge); }
  std::size_t slot_count() const { return nodes_.size(); }
  std::size_t edge_count() const { return edge_count_; }
  std::size_t hole_count() const;
  const std::vector<Cycle>& cycles() const { return cycles_; }
  const Cycle& cycle(CycleId c) const { return cycles_[static_cast<std::uint32_t>(c)]; }
  /// The outer perimeter; edits may have put it anywhere in cycles(). Precondition: the polygon is not empty.
  const Cycle& outer() const;
  const Box2& box() const { return box_; }
  /// Area without the holes, in grid steps squared. Updated by every edit, in double arithmetic.
  double area() const { return twice_area_ / 2; }

  /// The vertices of a cycle in its direction, from its first.
  std::vector<NewVertex> vertices(const Cycle&) const;
  /// All cycles, outer first, then holes in storage order.
  std::vector<std::vector<NewVertex>> boundary() const;

  /// Where p lies. Exact in the exact build.
  ///  (1) On the boundary when p is on an edge; otherwise inside when the boundary winds around p;
  ///  (2) where cycles start, the order of the holes, and the edits that led here do not matter;
  ///  (3) invariant under motions (predicates.hpp).
  Side locate(Point2 p) const;

  /// Calls f(Slot) for the edges whose bounding boxes meet `box`, in no particular order and perhaps more
  /// than once for an edge, until f returns true. Returns whether it did.
  template <class F>
  bool any_edge_near(const Box2& box, F&& f) const {
    return index_.any_near(box, nodes_.size(), [&](std::uint32_t i) {
      const Node& n = nodes_[i];
      return bool(n.edge) && box_of(n.at, at(n.next)).meets(box) && f(Slot{i});
    });
  }

  /// Does the candidate keep the invariant? Decided on the rounded coordinates as they stand.
  Verdict judge(const Edit&) const;

  /// Makes the change. Precondition: judge(edit) == valid.
  void commit(const Edit&, EdgeIds&);

  /// Judges the change, and makes it if it is valid.
  ///  (1) It is valid exactly when the resulting boundary keeps the invariant;
  ///  (2) if it is not, nothing has changed; otherwise the boundary is what the edit says, vertex for vertex;
  ///  (3) area() changes by the area of the edit, up to rounding.
  Verdict change(const Edit&, EdgeIds&);

  /// change() for operations that only add area: also refused when the area would grow by less than `least`
  /// (grid steps squared) and rounding does not explain it, which it does up to two steps along all new
  /// edges. A new point that is rounded across a part of the polygon thinner than a step can make a candidate
  /// that is valid but gives up most of the polygon.
  Verdict grow(const Edit&, EdgeIds&, double least = 0);

  /// Marks the edge that leaves `s` as shared or not. Its identity stays.
  void set_shared(Slot s, bool shared) { nodes_[static_cast<std::uint32_t>(s)].shared = shared; }

  /// Identities of the edges removed, and slots and identities of the edges inserted (with a new identity or
  /// a given one), since this was last asked.
  std::vector<EdgeId> take_removed();
  std::vector<std::pair<Slot, EdgeId>> take_created();
  /// Both, into vectors whose memory is used again.
  void take_changes(std::vector<EdgeId>& removed, std::vector<std::pair<Slot, EdgeId>>& created);
  /// What take_created() would give.
  const std::vector<std::pair<Slot, EdgeId>>& created() const { return created_; }

  /// How often the boundary has changed.
  std::uint64_t version() const { return version_; }
  /// How often a change may have joined two cycles into one.
  std::uint64_t joins() const { return joins_; }

 private:
  Slot add_node(const NewVertex&, CycleId, EdgeIds&);
  void free_node(Slot);
  void relabel(Slot first, CycleId, bool hole);
  CycleId add_cycle();
  void rebuild_index();
  void fill_index();
  /// The number of edges to build the index for. A polygon of few edges but many free slots has an index too,
  /// because a search without one visits every slot.
  std::size_t index_size() const {
    return nodes_.size() <= 2 * EdgeIndex::kMinimum ? edge_count_
                                                    : std::max(edge_count_, EdgeIndex::kMinimum);
  }
  struct Difference;  ///< what an edit removes and inserts: worked out once, judged, and committed
  struct Run;
  Verdict judge(const Edit&, Difference&) const;
  void commit(const Edit&, Difference&, EdgeIds&);
  std::vector<Run> runs_of(const Edit&) const;
  Verdict judge_new_edges(const Difference&) const;
  Verdict judge_swept(const Difference&) const;
  Verdict judge_orientation(const Edit&, Difference&) const;
  Verdict judge_growth(const Difference&, double least) const;
  std::size_t untouched_outer(const Edit&) const;
  std::optional<Slot> unwalked_vertex(const Difference&) const;
  void label_cycles(const Edit&, const Difference&, std::span<const Slot> loop_starts);
  /// Does this cycle of the candidate lie inside an odd number of the candidate's other cycles?
  bool inside_others(const std::vector<Point2>& cycle, const Difference&) const;

  std::vector<Node> nodes_;
  std::vector<Cycle> cycles_;
  std::vector<std::uint32_t> free_;
  std::size_t edge_count_ = 0;
  Point2 origin_;  ///< the first vertex there ever was: the point of reference for sums of areas
  double twice_area_ = 0;
  Box2 box_;
  EdgeIndex index_;
  std::vector<EdgeId> removed_;
  std::vector<std::pair<Slot, EdgeId>> created_;
  std::uint64_t version_ = 0, joins_ = 0;
};

/// A polygon as plain data, complete enough that a restored one goes on in the same way. Free slots are
/// included in their order, so that new vertices get the same slots. The edge index is not, but the box and
/// the number of edges it was built for are, because they decide when it is rebuilt.
struct PolygonState {
  std::vector<Polygon::Node> nodes;
  std::vector<Polygon::Cycle> cycles;
  std::vector<std::uint32_t> free;  ///< free slots; the last one is the next to be used
  Point2 origin;
  double twice_area = 0;
  Box2 box;
  Box2 index_box;                 ///< of the index's cells; meaningless when the index is not active
  std::uint64_t index_edges = 0;  ///< 0: the index is not active
  std::vector<EdgeId> removed;
  std::vector<std::pair<Slot, EdgeId>> created;
  std::uint64_t version = 0, joins = 0;
};

}  // namespace limpet::geometry
