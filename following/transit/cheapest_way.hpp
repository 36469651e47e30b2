// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace limpet::following {

/// From one node of a graph to another.
struct GraphLink {
  std::size_t to;
  double length;
};

/// The cheapest way from a node to one for which wanted(node), both included (Dijkstra 1959); empty: there is
/// none. `links`: of each node. Of equally cheap ones always the same.
template <class Wanted>
std::vector<std::size_t> cheapest_way(const std::vector<std::vector<GraphLink>>& links, std::size_t from,
                                      Wanted&& wanted) {
  std::vector<double> length(links.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> before(links.size(), links.size());
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  if (links.empty()) return {};
  length[from] = 0;
  open.emplace(0, from);
  while (!open.empty()) {
    const auto [so_far, node] = open.top();
    open.pop();
    if (so_far > length[node]) continue;
    if (wanted(node)) {
      std::vector<std::size_t> way;
      for (std::size_t i = node; i != links.size(); i = before[i]) way.push_back(i);
      std::reverse(way.begin(), way.end());
      return way;
    }
    for (const GraphLink& link : links[node]) {
      const double through = so_far + link.length;
      if (through >= length[link.to]) continue;
      length[link.to] = through;
      before[link.to] = node;
      open.emplace(through, link.to);
    }
  }
  return {};
}

}  // namespace limpet::following
