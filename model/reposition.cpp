// Copyright the limpet authors. GPL-3.0-or-later.
//
// Repositioning shared edges (thesis §2.4.4) as one transaction over a segment and its neighbours. The new
// places of all vertices are computed, and every perimeter judges its edit. Either all are made, or an edge
// is unshared and everything is computed anew; without shared edges there is nothing to move, so this ends.
#include <algorithm>
#include <cmath>
#include <map>

#include <limpet/geometry/predicates.hpp>

#include "corners_internal.hpp"
#include "sharing_internal.hpp"
#include "thresholds_internal.hpp"

namespace limpet::model::internal {
namespace {

using geometry::EdgeId;
using geometry::Point2;
using geometry::Slot;

class Repositioning {
 public:
  Repositioning(Complex& complex, const Segment& s, std::vector<EdgeId>& edges)
      : complex_(complex), table_(complex.edges()), s_(s), edges_(edges) {}

  void run() {
    for (int tries = 0;; ++tries) {
      std::erase_if(edges_, [&](EdgeId edge) { return !table_.shared(edge); });
      if (edges_.empty()) return;
      if (tries == kMaxRepositionTries) {
        for (const EdgeId edge : edges_) complex_.unshare(edge);
        return;
      }
      const auto offender = work_out();
      if (!offender) return complex_.commit_judged(transaction_);
      complex_.unshare(*offender);
    }
  }

 private:
  /// Computes the new places of all vertices, and the edits; or returns the edge that cannot follow.
  std::optional<EdgeId> work_out() {
    moves_.clear(), transaction_ = {};
    for (const EdgeId edge : edges_)
      if (!place_ends(edge)) return edge;
    for (const EdgeId edge : edges_)
      if (!pair_holds(edge)) return edge;
    for (const auto& [segment, places] : moves_) {
      const geometry::Polygon& perimeter = complex_.at(segment).polygon->perimeter;
      geometry::Edit edit = edit_of(perimeter, places);
      if (edit.chains.empty() && edit.loops.empty()) continue;
      if (perimeter.judge(edit) != geometry::Verdict::valid) return offender_on(segment, places);
      transaction_.edits.emplace_back(segment, std::move(edit));
    }
    return std::nullopt;
  }

  /// Of the edges that move on this perimeter, the one of lowest identity.
  EdgeId offender_on(std::uint32_t segment, const std::map<Slot, Point2>& places) {
    const geometry::Polygon& perimeter = complex_.at(segment).polygon->perimeter;
    for (const EdgeId edge : edges_) {
      const EdgePlace &mine = table_.at(edge), &other = table_.across(edge);
      const EdgePlace& here = segment == s_.slot ? mine : other;
      if (here.segment != segment) continue;
      for (const Slot end : {here.slot, perimeter.next(here.slot)})
        if (const auto move = places.find(end); move != places.end() && move->second != perimeter.at(end))
          return edge;
    }
    return edges_.front();
  }

  std::optional<CommonLine> line_of(const Segment& a, EdgeId edge, const Eigen::Vector3d& near) {
    return common_line(a.polygon->plane(), complex_.at(table_.across(edge).segment).polygon->plane(), near);
  }

  /// Finds the new place of an end vertex of `edge` on `a`, which is at `from` now; false if it would move by
  /// λ or more, or there is none. `other`: the edge on the other side of the vertex.
  bool place(const Segment& a, Slot vertex, EdgeId edge, EdgeId other, bool corner,
             const Eigen::Vector3d& from) {
    const auto line = line_of(a, edge, from);
    if (!line) return false;
    Eigen::Vector3d to = line->at(line->place_of(from));
    if (corner) {
      const auto point = place_of_corner(complex_, a, vertex, *line, other, from);
      if (!point) return false;
      to = *point;
    }
    if ((to - from).squaredNorm() >= complex_.setting().scale_at(from).lambda2) return false;
    moves_[a.slot][vertex] = geometry::round_to_grid(a.polygon->chart.project(to));
    return true;
  }

  bool place_ends(EdgeId edge) {
    const EdgePlace &mine = table_.at(edge), &theirs = table_.across(edge);
    const EdgeId copy = mine.partner;
    const Segment& n = complex_.at(theirs.segment);
    const auto &perimeter = s_.polygon->perimeter, &other = n.polygon->perimeter;
    for (const bool begin : {true, false}) {
      const Slot p = begin ? mine.slot : perimeter.next(mine.slot);
      const Slot q = begin ? other.next(theirs.slot) : theirs.slot;
      const EdgeId beside_p = perimeter.node(begin ? perimeter.prev(p) : p).edge;
      const EdgeId beside_q = other.node(begin ? q : other.prev(q)).edge;
      const bool corner_p = complex_.is_corner(s_, p), corner_q = complex_.is_corner(n, q);
      const Eigen::Vector3d from_p = s_.polygon->position(p);
      // Where neither end is a corner, both go to the foot of the same point.
      const Eigen::Vector3d from_q = corner_p || corner_q ? n.polygon->position(q) : from_p;
      if (!place(s_, p, edge, beside_p, corner_p, from_p) || !place(n, q, copy, beside_q, corner_q, from_q))
        return false;
    }
    return true;
  }

  /// The position of a vertex after the moves.
  Eigen::Vector3d after(const Segment& a, Slot vertex) const {
    if (const auto of_a = moves_.find(a.slot); of_a != moves_.end())
      if (const auto move = of_a->second.find(vertex); move != of_a->second.end())
        return a.polygon->at(move->second);
    return a.polygon->position(vertex);
  }

  /// After the moves, do the two copies keep their direction, and overlap?
  bool pair_holds(EdgeId edge) {
    const EdgePlace &mine = table_.at(edge), &theirs = table_.across(edge);
    const Segment& n = complex_.at(theirs.segment);
    const auto &perimeter = s_.polygon->perimeter, &other = n.polygon->perimeter;
    const Eigen::Vector3d p1 = after(s_, mine.slot), p2 = after(s_, perimeter.next(mine.slot)),
                          q1 = after(n, other.next(theirs.slot)), q2 = after(n, theirs.slot);
    const Eigen::Vector3d along =
        s_.polygon->position(perimeter.next(mine.slot)) - s_.polygon->position(mine.slot);
    const double length2 = along.dot(along),
                 least = kLeastKeptSteps * complex_.setting().step * std::sqrt(length2);
    if (along.dot(p2 - p1) < least || along.dot(q2 - q1) < least) return false;
    return std::min(along.dot(p2), along.dot(q2)) - std::max(along.dot(p1), along.dot(q1)) >= least;
  }

  /// The moves of a perimeter's vertices as one edit. A cycle of which all vertices move is replaced as a
  /// whole.
  static geometry::Edit edit_of(const geometry::Polygon& perimeter, const std::map<Slot, Point2>& places) {
    geometry::Edit edit;
    const auto moved = [&](Slot s) {
      const auto at = places.find(s);
      return at != places.end() && at->second != perimeter.at(s);
    };
    const auto as_moved = [&](Slot s) {
      return geometry::NewVertex{places.at(s), perimeter.node(s).edge, perimeter.node(s).shared};
    };
    std::vector<Slot> done;
    for (const auto& [slot, to] : places) {
      if (!moved(slot) || std::find(done.begin(), done.end(), slot) != done.end()) continue;
      Slot first = slot;
      while (moved(perimeter.prev(first)) && perimeter.prev(first) != slot) first = perimeter.prev(first);
      const bool whole = moved(perimeter.prev(first));
      std::vector<geometry::NewVertex> via;
      Slot s = first;
      do {
        via.push_back(as_moved(s));
        done.push_back(s);
        s = perimeter.next(s);
      } while (moved(s) && s != first);
      if (whole) {
        edit.loops.push_back(std::move(via));
        edit.removed_cycles.push_back(perimeter.node(first).cycle);
        continue;
      }
      const Slot from = perimeter.prev(first);
      edit.chains.push_back(
          {from, std::move(via), s, perimeter.node(from).edge, perimeter.node(from).shared});
    }
    return edit;
  }

  Complex& complex_;
  const EdgeTable& table_;
  const Segment& s_;
  std::vector<EdgeId>& edges_;  ///< those still shared
  std::map<std::uint32_t, std::map<Slot, Point2>> moves_;
  Transaction transaction_;
};

}  // namespace

void reposition(Complex& complex, const Segment& s, std::vector<EdgeId> edges) {
  if (edges.empty()) return;
  std::sort(edges.begin(), edges.end());
  complex.with_ends_apart([&] {
    Repositioning(complex, s, edges).run();
    complex.note_ends(edges);
  });
}

}  // namespace limpet::model::internal
