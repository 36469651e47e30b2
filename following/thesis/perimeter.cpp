// Copyright the limpet authors. GPL-3.0-or-later.
#include "edges_internal.hpp"
#include "perimeter_internal.hpp"

namespace limpet::following::internal {
namespace {

using Edges = std::vector<model::View::Edge>;

std::optional<Route> route(const Edges& edges, std::size_t from, bool forwards,
                           const std::function<bool(const model::View::Edge&)>& wanted) {
  Route result{from, forwards, 0};
  for (std::size_t i = beside(edges, from, forwards); i != from; i = beside(edges, i, forwards)) {
    result.to = i;
    if (wanted(edges[i])) return result;
    result.length += length(edges[i]);
  }
  return std::nullopt;
}

}  // namespace

std::size_t beside(const Edges& edges, std::size_t i, bool forwards) {
  const auto cycle = edges[i].cycle;
  // A cycle's edges stand side by side, so that only at its ends is there anything to look for.
  if (forwards) {
    if (i + 1 < edges.size() && edges[i + 1].cycle == cycle) return i + 1;
    while (i > 0 && edges[i - 1].cycle == cycle) --i;
    return i;
  }
  if (i > 0 && edges[i - 1].cycle == cycle) return i - 1;
  while (i + 1 < edges.size() && edges[i + 1].cycle == cycle) ++i;
  return i;
}

std::optional<Route> shortest_route(const Edges& edges, std::size_t from,
                                    const std::function<bool(const model::View::Edge&)>& wanted) {
  if (wanted(edges[from])) return Route{from, true, 0};
  const auto there = route(edges, from, true, wanted), back = route(edges, from, false, wanted);
  return back && back->length < there->length ? back : there;
}

}  // namespace limpet::following::internal
