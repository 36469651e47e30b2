// Copyright the limpet authors. GPL-3.0-or-later.
#include "edges_internal.hpp"
#include "pursuit_internal.hpp"

namespace limpet::following::internal {

void Pursuit::take(const Changes& changes) {
  segment = changes.now(segment);
  edge = changes.now(edge);
  follow = changes.now(follow);
  slices.take(changes);
  completeness.take(changes);
}

bool Pursuit::choose_edge(const model::View::Edge& chosen) {
  if (length(chosen) <= 0 || !goal_places.visit((chosen.from + chosen.to) / 2)) {
    completeness.mark_unclosable(chosen.id);
    return false;
  }
  edge = chosen.id;
  if (!slices.begin(chosen)) any_edge = true;
  return true;
}

void Pursuit::mark_unclosable(geometry::EdgeId id) {
  completeness.mark_unclosable(id);
  if (edge == id) edge = {};
}

void Pursuit::use_slice() {
  slices.use();
  any_edge = false;
}

}  // namespace limpet::following::internal
