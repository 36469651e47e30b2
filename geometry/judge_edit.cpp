// Copyright the limpet authors. GPL-3.0-or-later.
//
// Judging a candidate change of a polygon's boundary.
//
// Why judging only what changes suffices. Let the polygon be valid, and let (1) no new edge meet an edge that
// stays, or another new edge, except in a common vertex, and (2) no vertex that stays lie in the swept
// region, which is bounded by the removed and new edges under the even-odd rule. Then the new cycles are
// simple and disjoint, and the inside around every vertex that stays is where it was. So a cycle that keeps a
// vertex other than the ends of its chains has the inside on its left. For cycles that keep none this is
// tested explicitly, in O(n). With the inside on the left of all cycles, and exactly one of them
// anticlockwise, every other cycle is a hole in that one.
#include <cmath>
#include <limpet/geometry/predicates.hpp>

#include "edit_internal.hpp"

namespace limpet::geometry {

using internal::as_span;

namespace {

std::vector<Segment2> edges_of(const std::vector<Point2>& cycle) {
  std::vector<Segment2> edges;
  edges.reserve(cycle.size());
  for (std::size_t i = 0; i < cycle.size(); ++i) edges.emplace_back(cycle[i], cycle[(i + 1) % cycle.size()]);
  return edges;
}

/// What is known of a new cycle.
struct Ring {
  bool witnessed = false;  ///< a vertex other than the ends of its chains stays: the inside is on the left
  bool walked = true;      ///< all of its vertices have been collected
};

}  // namespace

Verdict Polygon::judge_new_edges(const Difference& d) const {
  if (const Verdict v = judge_edges(as_span(d.new_edges)); v != Verdict::valid) return v;
  for (const KeyedEdge& e : d.new_edges) {
    const bool conflict = any_edge_near(box_of(e.a, e.b), [&](Slot s) {
      if (d.removes(s)) return false;
      return in_conflict(e,
                         {at(s), end(s), static_cast<std::uint64_t>(s), static_cast<std::uint64_t>(next(s))});
    });
    if (conflict) return Verdict::crossing;
  }
  return Verdict::valid;
}

Verdict Polygon::judge_swept(const Difference& d) const {
  EvenOdd sweep(as_span(d.sweep));
  const bool swept = any_edge_near(d.box, [&](Slot s) {
    // A vertex whose edge is removed either goes too or begins a chain; one that ends a chain is on it as
    // well.
    if (!d.box.contains(at(s)) || d.removes(s) || d.ends_at(s)) return false;
    return sweep.inside(at(s));
  });
  return swept ? Verdict::swept_vertex : Verdict::valid;
}

Verdict Polygon::judge_growth(const Difference& d, double least) const {
  constexpr double kRounding = 2;
  double twice_gained = 0, rounded = 0;
  for (const Slot s : d.removed_edges) twice_gained -= cross(at(s) - origin_, end(s) - origin_);
  for (const KeyedEdge& e : d.new_edges) {
    twice_gained += cross(e.a - origin_, e.b - origin_);
    rounded += std::sqrt(squared_length(e.b - e.a));
  }
  return twice_gained / 2 - least >= -kRounding * rounded ? Verdict::valid : Verdict::shrinking;
}

/// The number of anticlockwise cycles that the edit leaves alone.
std::size_t Polygon::untouched_outer(const Edit& edit) const {
  std::vector<char> touched(cycles_.size());
  for (const CycleId id : edit.removed_cycles) touched[static_cast<std::uint32_t>(id)] = 1;
  for (const Chain& c : edit.chains) touched[static_cast<std::uint32_t>(node(c.from).cycle)] = 1;
  std::size_t outer = 0;
  for (std::size_t i = 0; i < cycles_.size(); ++i)
    outer += !touched[i] && cycles_[i].size > 0 && !cycles_[i].hole;
  return outer;
}

/// A vertex, both of whose edges stay, of the run that was not walked.
std::optional<Slot> Polygon::unwalked_vertex(const Difference& d) const {
  const auto run = std::find_if(d.runs.begin(), d.runs.end(), [](const Run& r) { return !r.walked; });
  if (run == d.runs.end()) return std::nullopt;
  return run->kept[1];
}

Verdict Polygon::judge_orientation(const Edit& edit, Difference& d) const {
  if (edit.chains.size() == 1 && edit.loops.empty() && edit.removed_cycles.empty()) {
    const Chain& chain = edit.chains.front();
    const std::size_t kept = cycle(node(chain.from).cycle).size - d.removed_vertices.size();
    if (chain.from != chain.to && kept >= 3) return Verdict::valid;
  }
  if (d.runs.empty()) d.runs = runs_of(edit);
  std::size_t outer = untouched_outer(edit);
  const bool outer_is_new = outer == 0;
  const std::optional<Slot> witness = unwalked_vertex(d);
  bool others_hold_witness = false;
  std::vector<Point2> points;
  const auto judge_cycle = [&](bool witnessed) {
    if (points.size() < 3) return Verdict::too_few_vertices;
    const int sign = chain_orientation(points);
    if (witness) others_hold_witness ^= inside_even_odd(edges_of(points), at(*witness));
    outer += sign > 0;
    const bool right = sign != 0 && (witnessed || inside_others(points, d) == (sign < 0));
    return right ? Verdict::valid : Verdict::orientation;
  };
  std::vector<char> seen(edit.chains.size());
  const auto collect = [&](std::size_t first) {
    points.clear();
    Ring ring;
    for (std::size_t c = first; !seen[c]; c = d.runs[c].next_chain) {
      seen[c] = 1;
      for (const NewVertex& v : edit.chains[c].via) points.push_back(v.at);
      for (const Slot s : d.runs[c].kept) points.push_back(at(s));
      ring.witnessed |= d.runs[c].kept.size() > 2;
      ring.walked &= d.runs[c].walked;
    }
    return ring;
  };
  std::optional<std::size_t> long_ring;
  for (std::size_t first = 0; first < edit.chains.size(); ++first) {
    if (seen[first]) continue;
    const Ring ring = collect(first);
    if (!ring.walked)
      long_ring = first;
    else if (const Verdict v = judge_cycle(ring.witnessed); v != Verdict::valid)
      return v;
  }
  for (const auto& loop : edit.loops) {
    points.clear();
    for (const NewVertex& v : loop) points.push_back(v.at);
    if (const Verdict v = judge_cycle(false); v != Verdict::valid) return v;
  }
  if (!long_ring) return outer == 1 ? Verdict::valid : Verdict::orientation;
  // The inside is bounded and lies on the left of all cycles, so at least one of them is anticlockwise. If no
  // other cycle is, then this one must be. Otherwise it must be a hole inside the other.
  if (outer == 0) return Verdict::valid;
  if (outer > 1) return Verdict::orientation;
  // It is a hole if the outside, which lies beside the witness, is within it. By the even-odd rule the new
  // cycles together are the old ones that were touched and the sweep, and the witness is not swept. Of the
  // old ones its own cycle has the outside beside it within it if it is a hole, and then so has the outer
  // one.
  const bool old_hold_witness = cycle(node(*witness).cycle).hole && !outer_is_new;
  return old_hold_witness != others_hold_witness ? Verdict::valid : Verdict::orientation;
}

bool Polygon::inside_others(const std::vector<Point2>& cycle, const Difference& d) const {
  // The new boundary is the exclusive or of the old one and the sweep. So for a vertex that is not on the old
  // boundary, locate() answers for the old one, and only the sweep has to be added. The cycle's own edges are
  // taken twice, and cancel.
  for (const Point2 p : cycle) {
    const Side side = locate(p);
    if (side == Side::boundary) continue;
    const bool inside_sweep = inside_even_odd(as_span(d.sweep), p) != inside_even_odd(edges_of(cycle), p);
    return (side == Side::inside) != inside_sweep;
  }
  std::vector<Segment2> edges = edges_of(cycle);
  for (std::uint32_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i].edge && !d.removes(Slot{i})) edges.emplace_back(at(Slot{i}), end(Slot{i}));
  for (const KeyedEdge& e : d.new_edges) edges.emplace_back(e.a, e.b);
  return inside_even_odd(edges, cycle.front());
}

Verdict Polygon::judge(const Edit& edit) const {
  Difference d(*this, edit);
  return judge(edit, d);
}

Verdict Polygon::judge(const Edit& edit, Difference& d) const {
  if (d.broken) return Verdict::orientation;
  if (const Verdict v = judge_new_edges(d); v != Verdict::valid) return v;
  if (const Verdict v = judge_swept(d); v != Verdict::valid) return v;
  return judge_orientation(edit, d);
}

}  // namespace limpet::geometry
