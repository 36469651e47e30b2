// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/geometry/judge.hpp>

#include <limpet/geometry/predicates.hpp>

namespace limpet::geometry {
namespace {

std::vector<Point2> points_of(const std::vector<NewVertex>& cycle) {
  std::vector<Point2> points;
  points.reserve(cycle.size());
  for (const NewVertex& v : cycle) points.push_back(v.at);
  return points;
}

std::vector<Segment2> edges_of(const std::vector<NewVertex>& cycle) {
  std::vector<Segment2> edges;
  edges.reserve(cycle.size());
  for (std::size_t i = 0; i < cycle.size(); ++i)
    edges.emplace_back(cycle[i].at, cycle[(i + 1) % cycle.size()].at);
  return edges;
}

/// Precondition: the cycles are disjoint, so that each lies wholly where its first vertex lies.
bool nested_rightly(std::span<const std::vector<NewVertex>> cycles) {
  std::vector<Box2> boxes(cycles.size());
  for (std::size_t i = 0; i < cycles.size(); ++i)
    for (const NewVertex& v : cycles[i]) boxes[i].add(v.at);
  for (std::size_t j = 0; j < cycles.size(); ++j) {
    const auto edges = edges_of(cycles[j]);
    EvenOdd cycle(edges);
    for (std::size_t i = 1; i < cycles.size(); ++i) {
      if (i == j) continue;
      const Point2 p = cycles[i].front().at;
      const bool inside = boxes[j].contains(p) && cycle.inside(p);
      if (inside != (j == 0)) return false;
    }
  }
  return true;
}

/// Calls f(i, j) for pairs i < j of edges that are near each other, all that touch among them, perhaps more
/// than once for a pair, until f returns true. Returns whether it did.
template <class F>
bool any_near_pair(std::span<const KeyedEdge> edges, F&& f) {
  constexpr std::size_t kFew = 8;
  if (edges.size() <= kFew) {
    for (std::size_t j = 1; j < edges.size(); ++j)
      for (std::size_t i = 0; i < j; ++i)
        if (f(i, j)) return true;
    return false;
  }
  Box2 box;
  for (const KeyedEdge& e : edges) box.add(e.a), box.add(e.b);
  const CellGrid grid(box, edges.size());
  // The edges of all cells in one array, cell by cell (a counting sort): `ends` first counts, then says where
  // each cell's edges begin and end.
  std::vector<std::uint32_t> ends(grid.count() + 1);
  for (const KeyedEdge& e : edges) grid.for_cells_on(e.a, e.b, [&](std::size_t cell) { ++ends[cell + 1]; });
  for (std::size_t cell = 1; cell < ends.size(); ++cell) ends[cell] += ends[cell - 1];
  std::vector<std::uint32_t> members(ends.back());
  std::vector<std::uint32_t> next(ends.begin(), ends.end() - 1);
  for (std::uint32_t i = 0; i < edges.size(); ++i)
    grid.for_cells_on(edges[i].a, edges[i].b, [&](std::size_t cell) { members[next[cell]++] = i; });
  for (std::size_t cell = 0; cell + 1 < ends.size(); ++cell)
    for (std::uint32_t l = ends[cell]; l < ends[cell + 1]; ++l)
      for (std::uint32_t k = ends[cell]; k < l; ++k) {
        const std::uint32_t i = members[k], j = members[l];
        const KeyedEdge &e = edges[i], &g = edges[j];
        if (box_of(e.a, e.b).meets(box_of(g.a, g.b)) && f(i, j)) return true;
      }
  return false;
}

}  // namespace

const char* to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::valid:
      return "valid";
    case Verdict::degenerate_edge:
      return "degenerate edge";
    case Verdict::crossing:
      return "crossing";
    case Verdict::swept_vertex:
      return "swept vertex";
    case Verdict::orientation:
      return "orientation";
    case Verdict::too_few_vertices:
      return "too few vertices";
    case Verdict::shrinking:
      return "shrinking";
  }
  return "?";
}

bool in_conflict(const KeyedEdge& e, const KeyedEdge& f) {
  const bool aa = e.key_a == f.key_a, ab = e.key_a == f.key_b, ba = e.key_b == f.key_a,
             bb = e.key_b == f.key_b;
  if (!(aa || ab || ba || bb)) return segments_meet(e.a, e.b, f.a, f.b);
  return (aa && edges_overlap(e.a, e.b, f.b)) || (ab && edges_overlap(e.a, e.b, f.a)) ||
         (ba && edges_overlap(e.b, e.a, f.b)) || (bb && edges_overlap(e.b, e.a, f.a));
}

std::vector<std::pair<std::size_t, std::size_t>> find_conflicts(std::span<const KeyedEdge> edges) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  any_near_pair(edges, [&](std::size_t i, std::size_t j) {
    if (in_conflict(edges[i], edges[j])) found.emplace_back(i, j);
    return false;
  });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

Verdict judge_edges(std::span<const KeyedEdge> edges) {
  for (const KeyedEdge& e : edges)
    if (e.a == e.b) return Verdict::degenerate_edge;
  const bool crossing =
      any_near_pair(edges, [&](std::size_t i, std::size_t j) { return in_conflict(edges[i], edges[j]); });
  return crossing ? Verdict::crossing : Verdict::valid;
}

Verdict judge_cycles(std::span<const std::vector<NewVertex>> cycles) {
  if (cycles.empty()) return Verdict::too_few_vertices;
  std::vector<KeyedEdge> edges;
  for (const auto& cycle : cycles) {
    if (cycle.size() < 3) return Verdict::too_few_vertices;
    const std::uint64_t base = edges.size();
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const std::size_t j = (i + 1) % cycle.size();
      edges.push_back({cycle[i].at, cycle[j].at, base + i, base + j});
    }
  }
  if (const Verdict v = judge_edges(edges); v != Verdict::valid) return v;
  for (std::size_t i = 0; i < cycles.size(); ++i)
    if (chain_orientation(points_of(cycles[i])) != (i == 0 ? 1 : -1)) return Verdict::orientation;
  return nested_rightly(cycles) ? Verdict::valid : Verdict::orientation;
}

Verdict judge_polygon(const Polygon& polygon) {
  const auto cycles = polygon.boundary();
  return judge_cycles(cycles);
}

}  // namespace limpet::geometry
