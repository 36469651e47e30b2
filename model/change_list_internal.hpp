// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <span>
#include <vector>

#include <limpet/model/changes.hpp>

namespace limpet::model::internal {

/// The changes of one call and the edges that they name. The next call reuses the memory.
class ChangeList {
 public:
  void add(Change::Kind kind, SegmentId first, SegmentId second, SegmentId result,
           std::span<const geometry::EdgeId> edges = {}) {
    changes_.push_back({kind, first, second, result, {}});
    edges_.insert(edges_.end(), edges.begin(), edges.end());
    ends_.push_back(edges_.size());
  }
  /// A change of edges of one segment; with no edges, nothing is added.
  void add(Change::Kind kind, SegmentId result, std::span<const geometry::EdgeId> edges) {
    if (!edges.empty()) add(kind, {}, {}, result, edges);
  }
  /// Fills in Change::edges, once all changes have been added (edges_ may move while it grows).
  void settle() {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < changes_.size(); begin = ends_[i++])
      changes_[i].edges = std::span(edges_).subspan(begin, ends_[i] - begin);
  }
  const std::vector<Change>& all() const { return changes_; }
  void clear() { changes_.clear(), edges_.clear(), ends_.clear(); }

 private:
  std::vector<Change> changes_;
  std::vector<geometry::EdgeId> edges_;
  std::vector<std::size_t> ends_;  ///< for each change, the end of its edges in edges_
};

}  // namespace limpet::model::internal
