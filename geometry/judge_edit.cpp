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
  const bool swept = any_edge_near(d.box, [&](Slot s) {
    // A vertex whose edge is removed either goes too or begins a chain; one that ends a chain is on it as
    // well.
    if (!d.box.contains(at(s)) || d.removes(s) || d.ends_at(s)) return false;
    return inside_even_odd(as_span(d.sweep), at(s));
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

Verdict Polygon::judge_orientation(const Edit& edit, Difference& d) const {
  if (edit.chains.size() == 1 && edit.loops.empty() && edit.removed_cycles.empty()) {
    const Chain& chain = edit.chains.front();
    const std::size_t kept = cycle(node(chain.from).cycle).size - d.removed_vertices.size();
    if (chain.from != chain.to && kept >= 3) return Verdict::valid;
  }
  if (d.runs.empty()) d.runs = runs_of(edit);
  std::size_t outer = untouched_outer(edit);
  const bool outer_is_new = outer == 0;
  Box2 outer_box;  // of a new anticlockwise cycle
  std::vector<Point2> points;
  const auto judge_cycle = [&](bool witnessed) {
    if (points.size() < 3) return Verdict::too_few_vertices;
    const int sign = chain_orientation(points);
    outer += sign > 0;
    if (sign > 0)
      for (const Point2 p : points) outer_box.add(p);
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
  const Point2 p = at(edit.chains[*long_ring].to);
  if (outer > 1 || (outer_is_new && !outer_box.contains(p))) return Verdict::orientation;
  return orientation_of(edit, d, *long_ring) < 0 ? Verdict::valid : Verdict::orientation;
}

/// Orientation of the new cycle that chain `first` is on, with all of its vertices visited.
int Polygon::orientation_of(const Edit& edit, const Difference& d, std::size_t first) const {
  std::vector<Point2> points;
  std::size_t c = first;
  do {
    for (const NewVertex& v : edit.chains[c].via) points.push_back(v.at);
    const std::size_t next_chain = d.runs[c].next_chain;
    for (Slot s = edit.chains[c].to; s != edit.chains[next_chain].from; s = next(s)) points.push_back(at(s));
    points.push_back(at(edit.chains[next_chain].from));
    c = next_chain;
  } while (c != first);
  return chain_orientation(points);
}

bool Polygon::inside_others(const std::vector<Point2>& cycle, const Difference& d) const {
  std::vector<Segment2> edges;
  // The new boundary is the exclusive or of the old one and the sweep. So for a vertex that is not on the old
  // boundary, locate() answers for the old one, and only the sweep has to be added.
  for (const Point2 p : cycle) {
    const Side side = locate(p);
    if (side == Side::boundary) continue;
    edges.assign(d.sweep.begin(), d.sweep.end());
    for (std::size_t i = 0; i < cycle.size(); ++i)
      edges.emplace_back(cycle[i], cycle[(i + 1) % cycle.size()]);
    return (side == Side::inside) != inside_even_odd(edges, p);
  }
  for (std::uint32_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i].edge && !d.removes(Slot{i})) edges.emplace_back(at(Slot{i}), end(Slot{i}));
  for (const KeyedEdge& e : d.new_edges) edges.emplace_back(e.a, e.b);
  for (std::size_t i = 0; i < cycle.size(); ++i) edges.emplace_back(cycle[i], cycle[(i + 1) % cycle.size()]);
  return inside_even_odd(edges, cycle.front());  // the cycle's own edges occur twice and cancel
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
