// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <span>
#include <vector>

#include <limpet/model/changes.hpp>
#include <limpet/model/model.hpp>
#include <limpet/model/view.hpp>

namespace limpet::following::internal {

/// What surface modelling changed in the last update (thesis §3.4.6): an edge is changed when perimeter
/// sections are removed, and then it is gone; one that was only repositioned keeps its identity.
class Changes {
 public:
  Changes(const model::Model& model, std::span<const model::Change> changes)
      : model_(&model), changes_(changes) {}

  /// Edges that are gone, in the order of the changes.
  std::vector<geometry::EdgeId> removed_edges() const;
  /// Segments that are gone under their identities: merged into others, or deleted.
  std::vector<model::SegmentId> gone_segments() const;
  /// The segment resulting from its mergers; none when it was deleted.
  model::SegmentId now(model::SegmentId id) const { return id ? model_->now(id) : id; }
  /// The edge, or none when it has been changed.
  geometry::EdgeId now(geometry::EdgeId) const;

 private:
  const model::Model* model_;
  std::span<const model::Change> changes_;
};

}  // namespace limpet::following::internal
