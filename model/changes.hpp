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
/// A caller that applies the changes can keep a copy of the model: its segments, and for each edge, by
/// identity, its segment, the edges before and after it, its partner, and its ends. A change names the edges
/// that were removed, created or moved; where they are now, the caller asks the model (View::edge()) after
/// the call. So
///   - edges of a segment that merged belong to `result`, unless they are named as removed;
///   - edges of a segment that was deleted are gone;
///   - an edge may be named more than once, and may be gone when the call is over.
struct Change {
  enum class Kind {
    created,         ///< segment `result` is new (a point segment, or an initial one)
    became_polygon,  ///< segment `result` is a planar polygon segment now (also told of initial ones)
    merged,          ///< `first` and `second` have become `result` (which may be `first`)
    deleted,         ///< segment `first` is gone: dissolved, redundant, or given up as outliers
    edges_removed,   ///< edges of `result` are gone, with their identities
    edges_created,   ///< edges of `result` that are new
    edges_moved,     ///< edges of `result` with a moved end, or that came from another segment
    shared,          ///< the two edges, on `first` and on `second`, are a corresponding pair now
    unshared,        ///< the two edges, on `first` and on `second`, are a pair no more
    corner_formed,   ///< around a ring of segments, which begins with `first` and `second`: an edge of each
  };
  Kind kind;
  SegmentId first, second, result;
  std::span<const geometry::EdgeId> edges;  ///< kept by the model; valid until the next call that changes it
};

}  // namespace limpet::model
