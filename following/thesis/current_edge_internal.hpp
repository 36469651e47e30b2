// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <optional>

#include "pursuit_internal.hpp"
#include "situation_internal.hpp"

namespace limpet::following::internal {

/// Current edge following (thesis §3.4.3): directs the control point along the slices of the unexposed
/// surface near the current edge, one after the other. Once all are used, the edge is unclosable.
class CurrentEdge {
 public:
  Decision follow(const Situation&, Pursuit&);

 private:
  using Edge = model::View::Edge;

  std::optional<Decision> along_slice(const Situation&, Pursuit&, const Edge&) const;
};

}  // namespace limpet::following::internal
