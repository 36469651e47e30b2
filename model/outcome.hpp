// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include <limpet/model/open_edges.hpp>

namespace limpet::model {

/// What finish() would leave, if it were called now (Model::would_finish()).
struct Outcome {
  /// An edge that is open now.
  struct Edge {
    SegmentId segment;
    geometry::EdgeId edge;
    bool closes = false;  ///< it would be shared, or the gap beside it filled
    /// If not: the condition that would refuse it a neighbour, and the segment it would not be shared with,
    /// as in OpenEdge.
    Refusal refusal = Refusal::none;
    SegmentId other;
  };
  /// An open edge that would be left, where it would be then; world frame.
  struct Left {
    SegmentId segment;  ///< of the finished model
    Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();
  };
  std::vector<Edge> edges;     ///< all edges that are open now, by segment and edge
  std::vector<Left> left;      ///< by segment
  std::size_t open_edges = 0;  ///< number of open edges that would be left
  std::size_t polygons = 0;    ///< number of polygons that there would be
  bool closed() const { return polygons > 0 && open_edges == 0; }
};

}  // namespace limpet::model
