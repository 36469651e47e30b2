// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <utility>

#include "marks_internal.hpp"

namespace limpet::following::internal {

using geometry::EdgeId;
using model::SegmentId;

void Completeness::take(const Changes& changes) {
  ++steps_;
  for (const EdgeId id : changes.removed_edges()) {
    unreachable_edges_.erase(id), unclosable_edges_.erase(id), edges_tried_again_.erase(id);
    closing_.erase(id);
  }
  for (const SegmentId id : changes.gone_segments())
    unreachable_segments_.erase(id), segments_tried_again_.erase(id);
}

std::vector<Completeness::NewMark> Completeness::take_new_marks() {
  std::vector<NewMark> marks;
  for (const EdgeId id : std::exchange(new_edges_, {})) marks.push_back({id, {}});
  for (const SegmentId id : std::exchange(new_segments_, {})) marks.push_back({{}, id});
  return marks;
}

void Completeness::take_back(const NewMark& mark) {
  unreachable_edges_.erase(mark.edge);
  unreachable_segments_.erase(mark.segment);
}

void Completeness::came_closest(const model::View::Nearest& closest) {
  if (is_unreachable(closest.segment) && segments_tried_again_.insert(closest.segment).second)
    unreachable_segments_.erase(closest.segment);
  if (unreachable_edges_.count(closest.edge) && edges_tried_again_.insert(closest.edge).second)
    unreachable_edges_.erase(closest.edge);
}

bool Completeness::ask_what_would_close(const model::Model& model, bool surely) {
  if (steps_ < (surely ? 1 : patience_)) return false;
  const model::Outcome outcome = model.would_finish();
  closing_.clear();
  for (const model::Outcome::Edge& edge : outcome.edges)
    if (edge.closes) closing_.insert(edge.edge);
  steps_ = 0;
  ++asked_;
  // The answer takes longer the larger the model is.
  constexpr std::int64_t kEdgesPerStep = 10;
  patience_ = static_cast<int>(std::max<std::int64_t>(kLeastPatience, model.counts().edges / kEdgesPerStep));
  return true;
}

bool Completeness::is_complete(const Edge& edge) const {
  return edge.partner || unreachable_edges_.count(edge.id) || unclosable_edges_.count(edge.id) ||
         closing_.count(edge.id);
}

bool Completeness::is_complete(const model::View& view, SegmentId id) const {
  if (is_unreachable(id)) return true;
  const auto segment = view.segment(id);
  if (segment && segment->kind == model::View::Kind::point) return false;
  std::vector<Edge> open;
  view.open_edges(id, open);
  return std::all_of(open.begin(), open.end(), [&](const Edge& e) { return is_complete(e); });
}

Marks Completeness::marks() const {
  return {{unreachable_segments_.begin(), unreachable_segments_.end()},
          {unreachable_edges_.begin(), unreachable_edges_.end()},
          {unclosable_edges_.begin(), unclosable_edges_.end()}};
}

}  // namespace limpet::following::internal
