// Copyright the limpet authors. GPL-3.0-or-later.
//
// What a change of a polygon's boundary removes and inserts, and making the change.
#include <algorithm>

#include <limpet/geometry/predicates.hpp>

#include "edit_internal.hpp"

namespace limpet::geometry {

using internal::as_span;
using internal::SmallVector;

void Polygon::Difference::note_ends_of_chains(const Edit& edit) {
  if (edit.chains.size() == 1) {
    start_ = edit.chains.front().from, end_ = edit.chains.front().to;
    return;
  }
  for (const Chain& chain : edit.chains) starts_.push_back(chain.from), ends_.push_back(chain.to);
  for (auto* slots : {&starts_, &ends_}) {
    std::sort(slots->begin(), slots->end());
    broken |= std::adjacent_find(slots->begin(), slots->end()) != slots->end();
  }
}

Polygon::Difference::Difference(const Polygon& polygon, const Edit& edit) {
  note_ends_of_chains(edit);
  std::uint64_t next_key = polygon.slot_count();  // keys of old vertices are their slots
  for (const Chain& chain : edit.chains) {
    if (broken) return;
    add_chain(polygon, chain, next_key);
  }
  for (const CycleId id : edit.removed_cycles) remove_cycle(polygon, id);
  // One chain alone removes no edge twice.
  if (edit.chains.size() + edit.removed_cycles.size() > 1 || removed_edges.size() > 8) {
    sorted_removed_ = removed_edges;
    std::sort(sorted_removed_.begin(), sorted_removed_.end());
    broken |= std::adjacent_find(sorted_removed_.begin(), sorted_removed_.end()) != sorted_removed_.end();
  }
  if (broken) return;
  for (const auto& loop : edit.loops) add_loop(loop, next_key);
  for (const auto& [p, q] : sweep) box.add(p), box.add(q);
}

void Polygon::Difference::add_chain(const Polygon& polygon, const Chain& chain, std::uint64_t& next_key) {
  remove_edge(polygon, chain.from);
  for (Slot s = polygon.next(chain.from); !ends_at(s); s = polygon.next(s)) {
    if (starts_at(s)) {  // another chain's, or this one's where the cycle has no end
      broken = true;
      return;
    }
    removed_vertices.push_back(s);
    remove_edge(polygon, s);
  }
  Point2 a = polygon.at(chain.from);
  auto key_a = static_cast<std::uint64_t>(chain.from);
  for (const NewVertex& v : chain.via) {
    add_edge(a, v.at, key_a, next_key);
    a = v.at, key_a = next_key++;
  }
  add_edge(a, polygon.at(chain.to), key_a, static_cast<std::uint64_t>(chain.to));
}

void Polygon::Difference::remove_cycle(const Polygon& polygon, CycleId id) {
  Slot s = polygon.cycle(id).first;
  for (std::uint32_t i = 0; i < polygon.cycle(id).size; ++i, s = polygon.next(s)) {
    removed_vertices.push_back(s);
    remove_edge(polygon, s);
  }
}

void Polygon::Difference::add_loop(const std::vector<NewVertex>& loop, std::uint64_t& next_key) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const std::size_t j = (i + 1) % loop.size();
    add_edge(loop[i].at, loop[j].at, next_key + i, next_key + j);
  }
  next_key += loop.size();
}

void Polygon::Difference::remove_edge(const Polygon& polygon, Slot s) {
  removed_edges.push_back(s);
  sweep.emplace_back(polygon.at(s), polygon.end(s));
}

void Polygon::Difference::add_edge(Point2 a, Point2 b, std::uint64_t key_a, std::uint64_t key_b) {
  new_edges.push_back({a, b, key_a, key_b});
  sweep.emplace_back(a, b);
}

/// Walks all runs in lockstep until all but the longest one have ended; that one must then lead to the chain
/// that none of the others leads to, so its vertices need not be visited.
std::vector<Polygon::Run> Polygon::runs_of(const Edit& edit) const {
  constexpr std::size_t kWitness = 4;  // vertices that even the longest run is walked for
  const std::size_t n = edit.chains.size();
  std::vector<Run> runs(n);
  std::vector<std::pair<Slot, std::size_t>> starts;
  for (std::size_t i = 0; i < n; ++i) starts.emplace_back(edit.chains[i].from, i);
  std::sort(starts.begin(), starts.end());
  std::vector<char> led_to(n);
  std::vector<std::size_t> open(n);
  for (std::size_t i = 0; i < n; ++i) open[i] = i;
  while (open.size() > 1 || (open.size() == 1 && runs[open[0]].kept.size() < kWitness)) {
    std::erase_if(open, [&](std::size_t i) {
      Run& run = runs[i];
      const Slot s = run.kept.empty() ? edit.chains[i].to : next(run.kept.back());
      run.kept.push_back(s);
      const auto start = std::lower_bound(starts.begin(), starts.end(), std::pair(s, std::size_t{0}));
      if (start == starts.end() || start->first != s) return false;
      run.next_chain = start->second;
      run.walked = true;
      led_to[run.next_chain] = 1;
      return true;
    });
  }
  for (const std::size_t i : open)
    runs[i].next_chain =
        static_cast<std::size_t>(std::find(led_to.begin(), led_to.end(), 0) - led_to.begin());
  return runs;
}

void Polygon::commit(const Edit& edit, EdgeIds& ids) {
  Difference d(*this, edit);
  commit(edit, d, ids);
}

Verdict Polygon::change(const Edit& edit, EdgeIds& ids) {
  Difference d(*this, edit);
  const Verdict verdict = judge(edit, d);
  if (verdict == Verdict::valid) commit(edit, d, ids);
  return verdict;
}

Verdict Polygon::grow(const Edit& edit, EdgeIds& ids, double least) {
  Difference d(*this, edit);
  Verdict verdict = judge(edit, d);
  if (verdict == Verdict::valid) verdict = judge_growth(d, least);
  if (verdict == Verdict::valid) commit(edit, d, ids);
  return verdict;
}

void Polygon::commit(const Edit& edit, Difference& d, EdgeIds& ids) {
  for (const Slot s : d.removed_edges) twice_area_ -= cross(at(s) - origin_, end(s) - origin_);
  for (const KeyedEdge& e : d.new_edges) twice_area_ += cross(e.a - origin_, e.b - origin_);
  const auto ref = [this](Slot s) -> Node& { return nodes_[static_cast<std::uint32_t>(s)]; };
  const bool simple = edit.chains.size() == 1 && edit.loops.empty() && edit.removed_cycles.empty();
  if (!simple && d.runs.empty()) d.runs = runs_of(edit);
  SmallVector<EdgeId, 8> kept;  // identities of removed edges that new edges take over
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
  joins_ += std::any_of(edit.chains.begin(), edit.chains.end(), [&](const Chain& c) {
    return node(c.from).cycle != node(edit.chains.front().from).cycle;
  });
  for (const Slot s : d.removed_vertices) free_node(s);

  SmallVector<Slot, 16> touched;  // slots whose edges are new
  for (const Chain& c : edit.chains) {
    const CycleId id = node(c.from).cycle;
    Slot last = c.from;
    ref(last).edge = c.edge ? c.edge : ids.take();  // `from` stays, but the edge that left it was removed
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
    label_cycles(edit, d, loop_starts);
  }
  ++version_;
  if (!index_.fits(box_, index_size())) return rebuild_index();
  if (!index_.active()) return;
  for (const Slot s : touched) index_.add(static_cast<std::uint32_t>(s), at(s), end(s));
  index_.flip(as_span(d.sweep));
}

/// Labels the vertices with their new cycles. The cycle with the run that was not walked, if there is one,
/// keeps its old label, so that the vertices of that run need not be visited.
void Polygon::label_cycles(const Edit& edit, const Difference& d, std::span<const Slot> loop_starts) {
  std::vector<CycleId> freed = edit.removed_cycles;
  for (const Chain& c : edit.chains) freed.push_back(node(c.from).cycle);
  std::sort(freed.begin(), freed.end());
  freed.erase(std::unique(freed.begin(), freed.end()), freed.end());
  std::size_t vertices = 0;  // on all new cycles; in the end, on the one that keeps its label
  for (const CycleId id : freed) vertices += cycle(id).size;
  vertices -= d.removed_vertices.size();
  for (const Chain& c : edit.chains) vertices += c.via.size();
  for (const auto& loop : edit.loops) vertices += loop.size();

  const auto open = std::find_if(d.runs.begin(), d.runs.end(), [](const Run& r) { return !r.walked; });
  const bool walked = open == d.runs.end();
  const CycleId kept = walked ? CycleId{} : node(open->kept.front()).cycle;
  std::vector<char> labelled(edit.chains.size());
  const auto set_labelled = [&](std::size_t first) {  // all chains on the cycle of this one
    for (std::size_t c = first; !labelled[c]; c = d.runs[c].next_chain) labelled[c] = 1;
  };
  if (!walked) set_labelled(static_cast<std::size_t>(open - d.runs.begin()));
  const std::vector<char> on_kept = labelled;
  for (const CycleId id : freed)
    if (walked || id != kept) cycles_[static_cast<std::uint32_t>(id)] = {};

  const auto label = [&](Slot first) {
    std::vector<Point2> points;
    Slot s = first;
    do points.push_back(at(s)), s = next(s);
    while (s != first);
    relabel(first, add_cycle(), chain_orientation(points) < 0);
    vertices -= points.size();
  };
  for (const Slot first : loop_starts) label(first);
  for (std::size_t c = 0; c < edit.chains.size(); ++c) {
    if (labelled[c]) continue;
    label(edit.chains[c].from);
    set_labelled(c);
  }
  if (walked) return;
  for (std::size_t c = 0; c < edit.chains.size(); ++c) {
    if (!on_kept[c]) continue;
    Slot s = next(edit.chains[c].from);  // the vertices of the chain, then those of the run behind it
    const Run& run = d.runs[c];
    for (; s != edit.chains[c].to; s = next(s)) nodes_[static_cast<std::uint32_t>(s)].cycle = kept;
    if (run.walked)
      for (const Slot t : run.kept) nodes_[static_cast<std::uint32_t>(t)].cycle = kept;
  }
  Cycle& cycle = cycles_[static_cast<std::uint32_t>(kept)];
  cycle.first = open->kept.front();
  cycle.size = static_cast<std::uint32_t>(vertices);
  cycle.hole = false;
  for (std::size_t i = 0; i < cycles_.size(); ++i)
    cycle.hole |= CycleId{static_cast<std::uint32_t>(i)} != kept && cycles_[i].size > 0 && !cycles_[i].hole;
}

}  // namespace limpet::geometry
