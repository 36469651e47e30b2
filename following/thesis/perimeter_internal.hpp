// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include <limpet/model/view.hpp>

namespace limpet::following::internal {

/// A way along one perimeter cycle.
struct Route {
  std::size_t to = 0;    ///< index of the edge it leads to
  bool forwards = true;  ///< anticlockwise about an outer perimeter
  double length = 0;     ///< of the edges between, without the first and last
};

/// The shortest way along the perimeter from an edge to one that is wanted (it itself, if it is). `edges` are
/// all edges of the segment, as View::edges() gives them. Nothing when its cycle has none.
std::optional<Route> shortest_route(const std::vector<model::View::Edge>& edges, std::size_t from,
                                    const std::function<bool(const model::View::Edge&)>& wanted);

/// Index of the next edge of the same cycle, forwards or backwards.
std::size_t beside(const std::vector<model::View::Edge>& edges, std::size_t i, bool forwards);

}  // namespace limpet::following::internal
