// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstddef>
#include <vector>

#include <limpet/model/open_edges.hpp>

namespace limpet::model {

/// What finishing would come to (Model::would_finish()).
struct Outcome {
  /// An edge that is open now.
  struct Edge {
    SegmentId segment;
    geometry::EdgeId edge;
    bool closes = false;  ///< it would be shared, or what is beside it be filled
    /// Else what would refuse it a neighbour, and which segment that would have been (as in OpenEdge).
    Refusal refusal = Refusal::none;
    SegmentId other;
  };
  std::vector<Edge> edges;     ///< all that are open now, by segment and edge
  std::size_t open_edges = 0;  ///< that would be left
  std::size_t polygons = 0;    ///< that there would be
  bool closed() const { return polygons > 0 && open_edges == 0; }
};

}  // namespace limpet::model
