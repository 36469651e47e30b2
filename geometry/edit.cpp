// Copyright the limpet authors. GPL-3.0-or-later.
//
// Judging and committing a candidate change of a polygon's boundary.
//
// Why the local judgement suffices. Let the polygon be valid, and let (1) no new edge meet an edge that
// stays, or another new edge, but in a common vertex, and (2) no vertex that stays lie in the swept region
// (the even-odd region of removed and new edges). Then the new cycles are simple and disjoint, and around
// every vertex that stays the inside is where it was, so each cycle that keeps a vertex besides the ends of
// its chains keeps the inside on its left. Of cycles that keep none it is asked explicitly, in O(n). With the
// inside on the left of all cycles, and one of them anticlockwise, each of the others is a hole in that one.
#include <limpet/geometry/judge.hpp>
#include <limpet/geometry/polygon.hpp>
#include <limpet/geometry/predicates.hpp>

namespace limpet::geometry {

struct Polygon::Difference {
  std::vector<Slot> removed_edges;  ///< these bear the polygon's stamp
  std::vector<Slot> removed_vertices;
  std::vector<KeyedEdge> new_edges;
  std::vector<Segment2> sweep;
  std::vector<Slot> starts, ends;  ///< of the chains, sorted
  Box2 box;
  bool broken = false;  ///< the chains and removed cycles get into each other's way

  void add_edge(Point2 a, Point2 b, std::uint64_t key_a, std::uint64_t key_b) {
    new_edges.push_back({a, b, key_a, key_b});
    sweep.emplace_back(a, b);
  }
  bool starts_at(Slot s) const { return std::binary_search(starts.begin(), starts.end(), s); }
  bool ends_at(Slot s) const { return std::binary_search(ends.begin(), ends.end(), s); }
};

Polygon::Difference Polygon::difference(const Edit& edit) const {
  Difference d;
  for (const Chain& chain : edit.chains) d.starts.push_back(chain.from), d.ends.push_back(chain.to);
  for (auto* slots : {&d.starts, &d.ends}) {
    std::sort(slots->begin(), slots->end());
    if (std::adjacent_find(slots->begin(), slots->end()) != slots->end()) return d.broken = true, d;
  }
  ++stamp_;
  const auto remove_edge = [&](Slot s) {
    d.broken |= node(s).mark == stamp_;
    node(s).mark = stamp_;
    d.removed_edges.push_back(s);
    d.sweep.emplace_back(at(s), end(s));
  };
  std::uint64_t key = nodes_.size();  // keys of new vertices follow the slots
  for (const Chain& chain : edit.chains) {
    remove_edge(chain.from);
    for (Slot s = next(chain.from); !d.ends_at(s) && !d.broken; s = next(s)) {
      d.broken |= d.starts_at(s);
      d.removed_vertices.push_back(s);
      remove_edge(s);
    }
    if (d.broken) return d;
    Point2 a = at(chain.from);
    auto key_a = static_cast<std::uint64_t>(chain.from);
    for (const NewVertex& v : chain.via) {
      d.add_edge(a, v.at, key_a, key);
      a = v.at, key_a = key++;
    }
    d.add_edge(a, at(chain.to), key_a, static_cast<std::uint64_t>(chain.to));
  }
  for (const CycleId id : edit.removed_cycles) {
    Slot s = cycle(id).first;
    for (std::uint32_t i = 0; i < cycle(id).size; ++i, s = next(s)) {
      d.removed_vertices.push_back(s);
      remove_edge(s);
    }
  }
  if (d.broken) return d;
  for (const auto& loop : edit.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::size_t j = (i + 1) % loop.size();
      d.add_edge(loop[i].at, loop[j].at, key + i, key + j);
    }
    key += loop.size();
  }
  for (const auto& [p, q] : d.sweep) d.box.add(p), d.box.add(q);
  return d;
}

Verdict Polygon::judge_new_edges(const Difference& d) const {
  if (const Verdict v = judge_edges(d.new_edges); v != Verdict::valid) return v;
  for (const KeyedEdge& e : d.new_edges) {
    const bool conflict = any_edge_near(box_of(e.a, e.b), [&](Slot s) {
      if (node(s).mark == stamp_) return false;
      return in_conflict(e,
                         {at(s), end(s), static_cast<std::uint64_t>(s), static_cast<std::uint64_t>(next(s))});
    });
    if (conflict) return Verdict::crossing;
  }
  return Verdict::valid;
}

Verdict Polygon::judge_swept(const Difference& d) const {
  const bool swept = any_edge_near(d.box, [&](Slot s) {
    // A vertex stays when its own edge does, or when it begins a removed stretch (then it is on a chain).
    if (node(s).mark == stamp_ || !d.box.contains(at(s)) || d.ends_at(s)) return false;
    return inside_even_odd(d.sweep, at(s));
  });
  return swept ? Verdict::swept_vertex : Verdict::valid;
}

Verdict Polygon::judge_orientation(const Edit& edit, const Difference& d) const {
  if (edit.chains.size() == 1 && edit.loops.empty() && edit.removed_cycles.empty()) {
    const Chain& chain = edit.chains.front();
    const std::size_t kept = cycle(node(chain.from).cycle).size - d.removed_vertices.size();
    if (chain.from != chain.to && kept >= 3) return Verdict::valid;
  }
  std::size_t outer = 0;
  std::vector<char> affected(cycles_.size());
  for (const CycleId id : edit.removed_cycles) affected[static_cast<std::uint32_t>(id)] = 1;
  for (const Chain& c : edit.chains) affected[static_cast<std::uint32_t>(node(c.from).cycle)] = 1;
  for (std::size_t i = 0; i < cycles_.size(); ++i)
    outer += !affected[i] && cycles_[i].size > 0 && !cycles_[i].hole;

  std::vector<Point2> points;
  const auto judge_cycle = [&](bool witnessed) {
    if (points.size() < 3) return Verdict::too_few_vertices;
    const int sign = chain_orientation(points);
    outer += sign > 0;
    const bool right = sign != 0 && (witnessed || inside_others(points, d) == (sign < 0));
    return right ? Verdict::valid : Verdict::orientation;
  };
  std::vector<char> seen(edit.chains.size());
  for (std::size_t first = 0; first < edit.chains.size(); ++first) {
    if (seen[first]) continue;
    points.clear();
    bool witnessed = false;
    for (std::size_t c = first; !seen[c];) {
      seen[c] = 1;
      for (const NewVertex& v : edit.chains[c].via) points.push_back(v.at);
      // Along what stays, from this chain's end to the start of the next one.
      Slot s = edit.chains[c].to;
      std::size_t kept = 1;
      for (; node(s).mark != stamp_; s = next(s), ++kept) points.push_back(at(s));
      points.push_back(at(s));
      witnessed |= kept > 2;
      c = static_cast<std::size_t>(
          std::find_if(edit.chains.begin(), edit.chains.end(), [s](const Chain& k) { return k.from == s; }) -
          edit.chains.begin());
    }
    if (const Verdict v = judge_cycle(witnessed); v != Verdict::valid) return v;
  }
  for (const auto& loop : edit.loops) {
    points.clear();
    for (const NewVertex& v : loop) points.push_back(v.at);
    if (const Verdict v = judge_cycle(false); v != Verdict::valid) return v;
  }
  return outer == 1 ? Verdict::valid : Verdict::orientation;
}

bool Polygon::inside_others(const std::vector<Point2>& cycle, const Difference& d) const {
  std::vector<Segment2> edges;
  // The new boundary is the old one exclusive-or the sweep, so a vertex off the old one is placed by
  // locate().
  for (const Point2 p : cycle) {
    const Side side = locate(p);
    if (side == Side::boundary) continue;
    edges = d.sweep;
    for (std::size_t i = 0; i < cycle.size(); ++i)
      edges.emplace_back(cycle[i], cycle[(i + 1) % cycle.size()]);
    return (side == Side::inside) != inside_even_odd(edges, p);
  }
  for (const Node& n : nodes_)
    if (n.edge && n.mark != stamp_) edges.emplace_back(n.at, at(n.next));
  for (const KeyedEdge& e : d.new_edges) edges.emplace_back(e.a, e.b);
  for (std::size_t i = 0; i < cycle.size(); ++i) edges.emplace_back(cycle[i], cycle[(i + 1) % cycle.size()]);
  return inside_even_odd(edges, cycle.front());  // the cycle's own edges are there twice
}

Verdict Polygon::judge(const Edit& edit) const {
  const Difference d = difference(edit);
  if (d.broken) return Verdict::orientation;
  if (const Verdict v = judge_new_edges(d); v != Verdict::valid) return v;
  if (const Verdict v = judge_swept(d); v != Verdict::valid) return v;
  return judge_orientation(edit, d);
}

void Polygon::commit(const Edit& edit, EdgeIds& ids) {
  const Difference d = difference(edit);
  const auto ref = [this](Slot s) -> Node& { return nodes_[static_cast<std::uint32_t>(s)]; };
  const bool simple = edit.chains.size() == 1 && edit.loops.empty() && edit.removed_cycles.empty();
  std::vector<EdgeId> kept;  // identities that a new vertex brings along are not removed
  for (const Chain& c : edit.chains) {
    if (c.edge) kept.push_back(c.edge);
    for (const NewVertex& v : c.via)
      if (v.edge) kept.push_back(v.edge);
  }
  for (const auto& loop : edit.loops)
    for (const NewVertex& v : loop)
      if (v.edge) kept.push_back(v.edge);
  std::sort(kept.begin(), kept.end());
  for (const Slot s : d.removed_edges) {
    if (index_.active()) index_.remove(static_cast<std::uint32_t>(s), at(s), end(s));
    if (!std::binary_search(kept.begin(), kept.end(), node(s).edge)) removed_.push_back(node(s).edge);
  }
  std::vector<CycleId> freed = edit.removed_cycles;
  for (const Chain& c : edit.chains) freed.push_back(node(c.from).cycle);
  for (const Slot s : d.removed_vertices) free_node(s);

  std::vector<Slot> touched;  // slots whose edge is new
  for (const Chain& c : edit.chains) {
    const CycleId id = node(c.from).cycle;
    Slot last = c.from;
    ref(last).edge = c.edge ? c.edge : ids.take();  // the edge that left `from` is gone
    ref(last).shared = c.shared;
    created_.emplace_back(last, ref(last).edge);
    touched.push_back(last);
    for (const NewVertex& v : c.via) {
      const Slot s = add_node(v, id, ids);
      ref(last).next = s;
      ref(s).prev = last;
      touched.push_back(last = s);
    }
    ref(last).next = c.to;
    ref(c.to).prev = last;
  }
  if (simple) {
    const Chain& chain = edit.chains.front();
    Cycle& cycle = cycles_[static_cast<std::uint32_t>(node(chain.from).cycle)];
    cycle.size = static_cast<std::uint32_t>(cycle.size + chain.via.size() - d.removed_vertices.size());
    cycle.first = chain.from;
  } else {
    std::vector<Slot> loop_starts;
    for (const auto& loop : edit.loops) {
      Slot first = kNoSlot, last = kNoSlot;
      for (const NewVertex& v : loop) {
        const Slot s = add_node(v, CycleId{0}, ids);
        touched.push_back(s);
        if (first == kNoSlot)
          first = s;
        else
          ref(last).next = s, ref(s).prev = last;
        last = s;
      }
      ref(last).next = first, ref(first).prev = last;
      loop_starts.push_back(first);
    }
    for (const CycleId id : freed) cycles_[static_cast<std::uint32_t>(id)] = {};
    for (const Chain& c : edit.chains) loop_starts.push_back(c.from);
    ++stamp_;
    for (const Slot first : loop_starts) {
      if (node(first).mark == stamp_) continue;
      std::vector<Point2> points;
      Slot s = first;
      do {
        node(s).mark = stamp_;
        points.push_back(at(s));
        s = next(s);
      } while (s != first);
      relabel(first, add_cycle(), chain_orientation(points) < 0);
    }
  }
  ++version_;
  if (!index_.fits(box_, edge_count_)) return rebuild_index();
  if (!index_.active()) return;
  for (const Slot s : touched) index_.add(static_cast<std::uint32_t>(s), at(s), end(s));
  index_.flip(d.sweep);
}

}  // namespace limpet::geometry
