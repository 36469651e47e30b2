// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/geometry/mend.hpp>

#include <array>
#include <cmath>

#include <limpet/geometry/judge.hpp>
#include <limpet/geometry/predicates.hpp>
#include <limpet/geometry/search.hpp>

namespace limpet::geometry {
namespace {

using Cycle = std::vector<NewVertex>;
using Cycles = std::vector<Cycle>;

/// The edges of all cycles. Vertices are numbered through all cycles; an edge has the number of its start,
/// and these numbers are the keys.
std::vector<KeyedEdge> edges_of(const Cycles& cycles) {
  std::vector<KeyedEdge> edges;
  for (const Cycle& cycle : cycles) {
    const std::size_t base = edges.size();
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const std::size_t j = (i + 1) % cycle.size();
      edges.push_back({cycle[i].at, cycle[j].at, base + i, base + j});
    }
  }
  return edges;
}

/// The point nearest to p on this side of ab, at most two grid steps away from `home` along each axis.
std::optional<Point2> nearest_on_side(Point2 p, Point2 home, Point2 a, Point2 b, int side) {
  std::optional<Point2> best;
  double best2 = 0;
  for (double dx = -2; dx <= 2; ++dx)
    for (double dy = -2; dy <= 2; ++dy) {
      const Point2 q = home + Point2{dx, dy};
      const double d2 = squared_length(q - p);
      if ((best && d2 >= best2) || orientation(a, b, q) != side) continue;
      best = q, best2 = d2;
    }
  return best;
}

/// On which sides of edges vertices were before the transfer. Vertices, and the edges that leave them, by
/// number.
class Sides {
 public:
  /// `home`: the vertices as transferred, from where none is moved farther than two steps along an axis.
  Sides(std::vector<KeyedEdge> before, std::vector<Point2> home)
      : before_(std::move(before)), home_(std::move(home)) {}

  /// Moves the ends of either edge that are on the wrong side of the other.
  void restore(std::vector<Point2>& at, std::size_t e, std::size_t f) const {
    for (const auto& [edge, other] : {std::pair(e, f), std::pair(f, e)})
      for (const std::size_t vertex : {edge, end(edge)})
        if (vertex != other && vertex != end(other)) restore_vertex(at, vertex, other);
  }
  std::size_t end(std::size_t edge) const { return before_[edge].key_b; }

 private:
  void restore_vertex(std::vector<Point2>& at, std::size_t vertex, std::size_t edge) const {
    const Point2 a = at[edge], b = at[end(edge)], p = at[vertex];
    const int side = orientation(before_[edge].a, before_[edge].b, before_[vertex].a);
    if (side == 0 || orientation(a, b, p) == side) return;
    const Point2 foot = a + nearest_fraction(a, b, p) * (b - a);
    if (squared_length(foot - p) > 8) return;  // too far from the edge to be the cause of the conflict
    if (const auto moved = nearest_on_side(p, home_[vertex], a, b, side)) at[vertex] = *moved;
  }

  std::vector<KeyedEdge> before_;
  std::vector<Point2> home_;
};

void remove_vertex(Cycle& cycle, std::size_t i) {
  NewVertex& before = cycle[(i + cycle.size() - 1) % cycle.size()];
  before.edge = {}, before.shared = false;
  cycle.erase(cycle.begin() + static_cast<std::ptrdiff_t>(i));
}

void drop_close(Cycle& cycle) {
  for (std::size_t i = cycle.size(); i-- > 0 && cycle.size() > 1;)
    if (squared_length(cycle[i].at - cycle[(i + cycle.size() - 1) % cycle.size()].at) < 4)
      remove_vertex(cycle, i);
}

/// One round of removals: for each conflict, of the four ends of the two edges the one whose removal changes
/// the least area, unless an earlier removal of the round has changed one of these edges. Returns the area
/// that the boundary sweeps over.
double remove_conflicts(Cycles& cycles, const std::vector<KeyedEdge>& edges,
                        const std::vector<std::pair<std::size_t, std::size_t>>& conflicts) {
  std::vector<std::size_t> before(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) before[edges[i].key_b] = i;
  const auto area_of_removal = [&](std::size_t v) {
    return std::abs(cross(edges[v].a - edges[before[v]].a, edges[v].b - edges[before[v]].a)) / 2;
  };
  std::vector<char> changed(edges.size()), removed(edges.size());
  double area = 0;
  for (const auto& [e, f] : conflicts) {
    if (changed[e] || changed[f]) continue;
    std::size_t least = e;
    for (const std::size_t v : {std::size_t{edges[e].key_b}, f, std::size_t{edges[f].key_b}})
      if (area_of_removal(v) < area_of_removal(least)) least = v;
    if (changed[least] || changed[before[least]]) continue;
    area += area_of_removal(least);
    removed[least] = changed[least] = changed[before[least]] = 1;
  }
  std::size_t number = edges.size();
  for (auto cycle = cycles.rbegin(); cycle != cycles.rend(); ++cycle)
    for (std::size_t i = cycle->size(); i-- > 0;)
      if (removed[--number] && cycle->size() > 1) remove_vertex(*cycle, i);
  return area;
}

}  // namespace

bool restore_sides(Cycles& cycles, const Cycles& before) {
  constexpr int kRounds = 4;
  std::vector<KeyedEdge> edges = edges_of(cycles);
  std::vector<Point2> at;
  for (const KeyedEdge& e : edges) at.push_back(e.a);
  const Sides sides(edges_of(before), at);
  for (int round = 0;; ++round) {
    const auto conflicts = find_conflicts(edges);
    if (conflicts.empty()) break;
    if (round == kRounds) return false;
    for (const auto& [e, f] : conflicts) sides.restore(at, e, f);
    for (std::size_t i = 0; i < edges.size(); ++i) edges[i].a = at[i], edges[i].b = at[edges[i].key_b];
  }
  std::size_t number = 0;
  for (Cycle& cycle : cycles)
    for (NewVertex& v : cycle) v.at = at[number++];
  return true;
}

bool mend_cycles(Cycles& cycles, double area) {
  for (Cycle& cycle : cycles) drop_close(cycle);
  for (;;) {
    if (cycles.empty() || cycles.front().size() < 3) return false;
    std::erase_if(cycles, [](const Cycle& c) { return c.size() < 3; });
    const std::vector<KeyedEdge> edges = edges_of(cycles);
    const auto conflicts = find_conflicts(edges);
    if (conflicts.empty()) return true;
    area -= remove_conflicts(cycles, edges, conflicts);
    if (area < 0) return false;
  }
}

}  // namespace limpet::geometry
