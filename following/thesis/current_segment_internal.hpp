// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "pursuit_internal.hpp"
#include "situation_internal.hpp"

namespace limpet::following::internal {

/// Current segment following (thesis §3.4.2): chooses the current edge, and directs the control point to it
/// along the current segment's perimeter. To another perimeter of the segment, as the rim of a hole, it hops.
class CurrentSegment {
 public:
  Decision follow(const Situation&, Pursuit&);

 private:
  using Edge = model::View::Edge;

  bool ensure_edge(const Situation&, Pursuit&);
  bool choose_edge(const Situation&, Pursuit&);
  static bool may_close(const Situation&, const Edge&);
  void follow_edge(const Edge&, bool forwards, const Situation&, Pursuit&);
  void ensure_follow_edge(const Situation&, Pursuit&);
  void advance(const Situation&, Pursuit&);
  std::size_t index_of(geometry::EdgeId) const;
  Direction along_follow_edge(const Situation&, const Pursuit&) const;

  std::vector<Edge> edges_;  ///< of the current segment, now
  bool forwards_ = true;     ///< the current direction: anticlockwise
};

}  // namespace limpet::following::internal
