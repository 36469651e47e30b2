// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include <limpet/geometry/types.hpp>

namespace limpet::model {

/// Identity of a segment: given once, in ascending order, and never used again.
struct SegmentId {
  std::uint64_t value = 0;  ///< 0: no segment
  explicit operator bool() const { return value != 0; }
  friend auto operator<=>(const SegmentId&, const SegmentId&) = default;
};

/// What one update did to the model, in the order it happened.
struct Change {
  enum class Kind {
    created,         ///< segment `result` is new (a point segment)
    became_polygon,  ///< point segment `result` is a planar polygon segment now
    merged,          ///< `first` and `second` are `result` now (which may be one of the two)
    deleted,         ///< segment `first` is gone: dissolved, or given up as an outlier
    edges_removed,   ///< edges of `result` lost their identities
    shared,
    unshared,
    corner_formed,  ///< of the neighbour relation
  };
  Kind kind;
  SegmentId first, second, result;
  std::vector<geometry::EdgeId> edges;
};

}  // namespace limpet::model
