// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <limits>

#include "current_segment_internal.hpp"
#include "edges_internal.hpp"
#include "perimeter_internal.hpp"

namespace limpet::following::internal {

using model::View;

Decision CurrentSegment::follow(const Situation& now, Pursuit& pursuit) {
  const auto segment = now.view.segment(pursuit.segment);
  if (!segment) return Mode::current_surface;
  if (segment->kind == View::Kind::point) return Mode::point;
  now.view.edges(pursuit.segment, edges_);
  if (pursuit.edge && pursuit.progress.is_insufficient()) {
    pursuit.completeness.mark_unreachable(pursuit.edge);
    pursuit.clear_edge();
  }
  if (!ensure_edge(now, pursuit)) return Mode::current_surface;
  ensure_follow_edge(now, pursuit);
  advance(now, pursuit);
  const Edge& followed = edges_[index_of(pursuit.follow)];
  if (pursuit.any_edge && followed.id != pursuit.edge && !pursuit.completeness.is_complete(followed) &&
      pursuit.choose_edge(followed))
    return Mode::current_edge;
  if (followed.id == pursuit.edge && distance(followed, now.at) < now.parameters.stray_limit)
    return Mode::current_edge;
  return along_follow_edge(now, pursuit);
}

std::size_t CurrentSegment::index_of(geometry::EdgeId id) const {
  const auto found = std::find_if(edges_.begin(), edges_.end(), [&](const Edge& e) { return e.id == id; });
  return static_cast<std::size_t>(found - edges_.begin());
}

/// Chooses a current edge unless there is one that is not complete. False when the segment is complete.
bool CurrentSegment::ensure_edge(const Situation& now, Pursuit& pursuit) {
  const std::size_t current = index_of(pursuit.edge);
  if (current < edges_.size() && !pursuit.completeness.is_complete(edges_[current])) return true;
  pursuit.clear_edge();
  while (!pursuit.edge)
    if (!choose_edge(now, pursuit)) return false;
  return true;
}

/// Could the edge be closed as things are? Then there is another polygon beside it.
bool CurrentSegment::may_close(const Situation& now, const Edge& edge) {
  model::Which others;
  others.but = edge.segment;
  others.points = false;
  return now.view.nearest((edge.from + edge.to) / 2, 2 * now.parameters.resolution, others).has_value();
}

/// One attempt to choose: the incomplete edge closest, along the perimeter, to the one closest to the control
/// point. False when there is no incomplete edge.
bool CurrentSegment::choose_edge(const Situation& now, Pursuit& pursuit) {
  const auto incomplete = [&](const Edge& e) { return !pursuit.completeness.is_complete(e); };
  std::size_t first = nearest_edge(edges_, now.at);
  auto route = shortest_route(edges_, first, incomplete);
  if (!route) {  // hop
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < edges_.size(); ++i)
      if (incomplete(edges_[i]) && distance(edges_[i], now.at) < least)
        least = distance(edges_[i], now.at), route = Route{i, true, 0}, first = i;
  }
  if (!route) return false;
  if (may_close(now, edges_[route->to]) && pursuit.completeness.ask_what_would_close(now.model, false) &&
      !incomplete(edges_[route->to]))
    return true;
  if (!pursuit.choose_edge(edges_[route->to])) return true;
  follow_edge(edges_[first], route->forwards, now, pursuit);
  return true;
}

void CurrentSegment::follow_edge(const Edge& edge, bool forwards, const Situation& now, Pursuit& pursuit) {
  pursuit.follow = edge.id;
  forwards_ = forwards;
  pursuit.progress.restart(distance(edge, now.at) + length(edge));
}

/// Where the choice of follow edge has been cleared, the edge nearest to the control point is followed.
void CurrentSegment::ensure_follow_edge(const Situation& now, Pursuit& pursuit) {
  if (index_of(pursuit.follow) < edges_.size()) return;
  const std::size_t nearest = nearest_edge(edges_, now.at);
  const auto route = shortest_route(edges_, nearest, [&](const Edge& e) { return e.id == pursuit.edge; });
  follow_edge(edges_[route ? nearest : index_of(pursuit.edge)], !route || route->forwards, now, pursuit);
}

/// The follow edge becomes the one farthest along the perimeter, up to the current edge, that is within ρ.
void CurrentSegment::advance(const Situation& now, Pursuit& pursuit) {
  const std::size_t followed = index_of(pursuit.follow), current = index_of(pursuit.edge);
  std::size_t best = followed;
  for (std::size_t i = followed; i != current;) {
    i = beside(edges_, i, forwards_);
    if (distance(edges_[i], now.at) < now.parameters.stray_limit) best = i;
    if (i == followed) return;  // the current edge is on another perimeter
  }
  if (best != followed) follow_edge(edges_[best], forwards_, now, pursuit);
}

Direction CurrentSegment::along_follow_edge(const Situation& now, const Pursuit& pursuit) const {
  if (const auto out = towards_outside(now.view, pursuit.segment, now.at)) return {*out};
  const Edge& e = edges_[index_of(pursuit.follow)];
  return {forwards_ ? towards_and_along(e.from, e.to, now.at, now.parameters)
                    : towards_and_along(e.to, e.from, now.at, now.parameters)};
}

}  // namespace limpet::following::internal
