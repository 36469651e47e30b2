// Copyright the limpet authors. GPL-3.0-or-later.
#include "changes_internal.hpp"

namespace limpet::following::internal {

using geometry::EdgeId;
using model::Change;
using model::SegmentId;

std::vector<EdgeId> Changes::removed_edges() const {
  std::vector<EdgeId> removed;
  for (const Change& change : changes_)
    if (change.kind == Change::Kind::edges_removed)
      removed.insert(removed.end(), change.edges.begin(), change.edges.end());
  return removed;
}

std::vector<SegmentId> Changes::gone_segments() const {
  std::vector<SegmentId> gone;
  for (const Change& change : changes_) {
    if (change.kind == Change::Kind::deleted) gone.push_back(change.first);
    if (change.kind != Change::Kind::merged) continue;
    for (const SegmentId part : {change.first, change.second})
      if (part != change.result) gone.push_back(part);
  }
  return gone;
}

EdgeId Changes::now(EdgeId id) const { return id && model_->view().edge(id) ? id : EdgeId{}; }

}  // namespace limpet::following::internal
