// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include <limpet/geometry/edge_index.hpp>
#include <limpet/geometry/types.hpp>

namespace limpet::geometry {

/// A vertex to be, with what is known of the edge that leaves it.
struct NewVertex {
  Point2 at;
  EdgeId edge{};        ///< identity that survives; none: a new edge
  bool shared = false;  ///< the edge is a shared edge
};

/// A stretch of new boundary: the edges from -> via[0] -> ... -> to replace what followed `from`.
struct Chain {
  Slot from = kNoSlot;
  std::vector<NewVertex> via;
  Slot to = kNoSlot;
  EdgeId edge{};        ///< of the edge that then leaves `from`: identity that survives; none: a new edge
  bool shared = false;  ///< that edge is a shared edge
};

/// A candidate change of a polygon's boundary. What lies anticlockwise behind each chain's `from`, up to the
/// first `to` of any chain, is removed; whole cycles may be removed and new ones (loops) added. Judged by
/// judge(), then committed whole or dropped.
struct Edit {
  std::vector<Chain> chains;
  std::vector<std::vector<NewVertex>> loops;
  std::vector<CycleId> removed_cycles;
};

/// Why the judge refused a candidate.
enum class Verdict {
  valid,
  degenerate_edge,   ///< an edge without length
  crossing,          ///< two edges meet other than consecutive ones at their common vertex
  swept_vertex,      ///< the change would pass over a vertex that stays
  orientation,       ///< a cycle would turn the wrong way round, or the outer one is not unique
  too_few_vertices,  ///< a cycle with less than three vertices
  shrinking,         ///< of what may only grow, more area would go than rounding takes
};
const char* to_string(Verdict);

struct PolygonState;

/// A planar polygon: one outer perimeter (anticlockwise) and any number of hole perimeters (clockwise), so
/// that the inside is always on the left of an edge.
///
/// Invariant (kept by every edit that judge() accepts): all cycles are simple in the strict sense, no two
/// edges meet but consecutive ones at their common vertex; holes lie inside the outer perimeter and outside
/// each other.
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

  /// Puts together what state() took apart: what is done with it from then on gives the same bits. Throws
  /// std::invalid_argument, with the reason, when the links do not fit together or the polygon is not valid.
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
  const Box2& box() const { return box_; }
  /// Area, its holes left out, in grid steps squared. Kept by every edit, in double arithmetic.
  double area() const { return twice_area_ / 2; }

  /// The vertices of a cycle in its direction, from its first.
  std::vector<NewVertex> vertices(const Cycle&) const;
  /// All cycles, outer first, then holes in storage order.
  std::vector<std::vector<NewVertex>> boundary() const;

  /// Where p lies. Exact in the exact build.
  ///  (1) On the boundary when on an edge; else inside when the boundary winds round it;
  ///  (2) starts of cycles, the order of holes, and the edits that led here do not matter;
  ///  (3) motions (predicates.hpp) keep it.
  Side locate(Point2 p) const;

  /// Calls f(Slot) for every edge that touches `box` and maybe others near it; an edge may come more than
  /// once. f returns true to stop.
  template <class F>
  bool any_edge_near(const Box2& box, F&& f) const {
    return index_.any_near(box, nodes_.size(), [&](std::uint32_t i) {
      const Node& n = nodes_[i];
      return bool(n.edge) && box_of(n.at, at(n.next)).meets(box) && f(Slot{i});
    });
  }

  /// Does the candidate keep the invariant? Decided on the rounded coordinates as they stand. Changes
  /// nothing.
  Verdict judge(const Edit&) const;

  /// Makes the change. Precondition: judge(edit) == valid.
  void commit(const Edit&, EdgeIds&);

  /// Judges the change, and makes it if it is valid.
  ///  (1) It is valid exactly when the boundary it leads to keeps the invariant;
  ///  (2) when it is not, nothing has changed; else the boundary is what the edit says, vertex for vertex;
  ///  (3) area() follows, but for rounding.
  Verdict change(const Edit&, EdgeIds&);

  /// The same for what may only grow: refused, too, when less area than `least` would come, but for what
  /// rounding takes: two steps along the new edges. A rounded point may lie beyond a part of the polygon that
  /// is thinner than a step, from where all looks different.
  Verdict grow(const Edit&, EdgeIds&, double least = 0);

  /// Marks the edge that leaves `s` as shared or not. Its identity stays.
  void set_shared(Slot s, bool shared) { nodes_[static_cast<std::uint32_t>(s)].shared = shared; }

  /// Identities of edges removed, and slots of edges put in place (new ones, and those whose identity came
  /// along), since last taken.
  std::vector<EdgeId> take_removed();
  std::vector<std::pair<Slot, EdgeId>> take_created();

  /// Counts boundary changes.
  std::uint64_t version() const { return version_; }
  /// Counts those of them that may have made one cycle of two.
  std::uint64_t joins() const { return joins_; }

 private:
  Slot add_node(const NewVertex&, CycleId, EdgeIds&);
  void free_node(Slot);
  void relabel(Slot first, CycleId, bool hole);
  CycleId add_cycle();
  void rebuild_index();
  void fill_index();
  /// How many edges the index is for. Where many slots are free, looking at all of them would cost more.
  std::size_t index_size() const {
    return nodes_.size() <= 2 * EdgeIndex::kMinimum ? edge_count_
                                                    : std::max(edge_count_, EdgeIndex::kMinimum);
  }
  /// What an edit takes away and puts in place, worked out once for the judge and once for the commit.
  struct Difference;
  struct Run;
  Verdict judge(const Edit&, Difference&) const;
  void commit(const Edit&, Difference&, EdgeIds&);
  std::vector<Run> runs_of(const Edit&) const;
  Verdict judge_new_edges(const Difference&) const;
  Verdict judge_swept(const Difference&) const;
  Verdict judge_orientation(const Edit&, Difference&) const;
  Verdict judge_growth(const Difference&, double least) const;
  std::size_t untouched_outer(const Edit&) const;
  int orientation_of(const Edit&, const Difference&, std::size_t first_chain) const;
  void label_cycles(const Edit&, const Difference&, std::span<const Slot> loop_starts);
  /// Does this cycle of the candidate lie inside an odd number of its other cycles?
  bool inside_others(const std::vector<Point2>& cycle, const Difference&) const;

  std::vector<Node> nodes_;
  std::vector<Cycle> cycles_;
  std::vector<std::uint32_t> free_;
  std::size_t edge_count_ = 0;
  Point2 origin_;  ///< the first vertex there was; what areas are summed about
  double twice_area_ = 0;
  Box2 box_;
  EdgeIndex index_;
  std::vector<EdgeId> removed_;
  std::vector<std::pair<Slot, EdgeId>> created_;
  std::uint64_t version_ = 0, joins_ = 0;
};

/// All of a polygon, as plain data: free places and their order too, so that new vertices go where they would
/// have gone. The index of edges is not in it, but what it was built for: that decides when it is built anew.
struct PolygonState {
  std::vector<Polygon::Node> nodes;
  std::vector<Polygon::Cycle> cycles;
  std::vector<std::uint32_t> free;  ///< places among the nodes, the next one to be taken last
  Point2 origin;
  double twice_area = 0;
  Box2 box;
  Box2 index_box;                 ///< of the index's cells; of no meaning where it is not active
  std::uint64_t index_edges = 0;  ///< 0: not active
  std::vector<EdgeId> removed;
  std::vector<std::pair<Slot, EdgeId>> created;
  std::uint64_t version = 0, joins = 0;
};

}  // namespace limpet::geometry
