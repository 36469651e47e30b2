// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <compare>
#include <cstdint>
#include <span>

#include <limpet/geometry/types.hpp>

namespace limpet::model {

/// Identity of a segment: given once, in ascending order, and never used again.
struct SegmentId {
  std::uint64_t value = 0;  ///< 0: no segment
  explicit operator bool() const { return value != 0; }
  friend auto operator<=>(const SegmentId&, const SegmentId&) = default;
};

/// What one call did to the model, in the order it happened.
///
/// Who applies the changes to a copy has the model: a copy of its segments, and for each edge by its identity
/// the segment, the neighbours on the perimeter, the partner, and where its ends are. Edges are named when
/// they go, come, or are elsewhere; where they are now is asked of the model when the call is over. So
///   - edges of a segment that merged are those of `result`, unless they are named as removed;
///   - edges of a segment that was deleted are gone;
///   - an edge may be named more than once, and be gone when the call is over.
struct Change {
  enum class Kind {
    created,         ///< segment `result` is new (a point segment, or an initial one)
    became_polygon,  ///< point segment `result` is a planar polygon segment now
    merged,          ///< `first` and `second` are `result` now (which may be `first`)
    deleted,         ///< segment `first` is gone: dissolved, redundant, or given up as an outlier
    edges_removed,   ///< edges of `result` lost their identities
    edges_created,   ///< edges of `result` that are new
    edges_moved,     ///< edges of `result` with an end elsewhere, or that come from another segment
    shared,          ///< the two edges, of `first` and `second`, are a corresponding pair
    unshared,        ///< they are none any more
    corner_formed,   ///< of the neighbour relation, by these edges
  };
  Kind kind;
  SegmentId first, second, result;
  std::span<const geometry::EdgeId> edges;  ///< kept by the model; valid until the next call that changes it
};

}  // namespace limpet::model
