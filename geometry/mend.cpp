// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/geometry/mend.hpp>

#include <cmath>

#include <limpet/geometry/judge.hpp>

namespace limpet::geometry {
namespace {

using Cycle = std::vector<NewVertex>;

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

/// Area that the boundary passes over when vertex i goes.
double area_of_removal(const Cycle& cycle, std::size_t i) {
  const std::size_t n = cycle.size();
  const Point2 a = cycle[(i + n - 1) % n].at, b = cycle[i].at, c = cycle[(i + 1) % n].at;
  return std::abs(cross(b - a, c - a)) / 2;
}

struct Place {
  std::size_t cycle = 0, vertex = 0;
};

}  // namespace

bool mend_cycles(std::vector<std::vector<NewVertex>>& cycles, double area) {
  for (Cycle& cycle : cycles) drop_close(cycle);
  for (;;) {
    if (cycles.empty() || cycles.front().size() < 3) return false;
    std::erase_if(cycles, [](const Cycle& c) { return c.size() < 3; });
    std::vector<KeyedEdge> edges;
    std::vector<Place> places;
    for (std::size_t c = 0; c < cycles.size(); ++c) {
      const std::uint64_t base = edges.size();
      for (std::size_t i = 0; i < cycles[c].size(); ++i) {
        const std::size_t j = (i + 1) % cycles[c].size();
        edges.push_back({cycles[c][i].at, cycles[c][j].at, base + i, base + j});
        places.push_back({c, i});
      }
    }
    const auto conflict = find_conflict(edges);
    if (!conflict) return true;
    Place least;
    double smallest = -1;
    for (const std::size_t e : {conflict->first, conflict->second})
      for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
        const Cycle& cycle = cycles[places[e].cycle];
        const Place p{places[e].cycle, (places[e].vertex + end) % cycle.size()};
        const double change = area_of_removal(cycle, p.vertex);
        if (smallest < 0 || change < smallest) smallest = change, least = p;
      }
    area -= smallest;
    if (area < 0) return false;
    remove_vertex(cycles[least.cycle], least.vertex);
  }
}

}  // namespace limpet::geometry
