// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <array>
#include <cstdint>
#include <limpet/drawing/varint.hpp>
#include <vector>

namespace limpet::drawing {

/// A place in whole steps about an origin.
using Place = std::array<std::int64_t, 3>;

/// A vertex of an boundary, and the edge from it to the next one.
struct BoundaryVertex {
  std::uint64_t edge = 0;
  std::uint64_t partner = 0;  ///< 0: the edge is open
  Place at{};
  friend bool operator==(const BoundaryVertex&, const BoundaryVertex&) = default;
};

/// The boundary of a polygon: the outer cycle first, then the holes, interior on the left.
struct Boundary {
  struct Cycle {
    bool hole = false;
    std::vector<BoundaryVertex> vertices;
    friend bool operator==(const Cycle&, const Cycle&) = default;
  };
  std::vector<Cycle> cycles;
  friend bool operator==(const Boundary&, const Boundary&) = default;
};

/// Puts an boundary as what is new against the one before, which may be empty (docs/page_format.md,
/// "Boundaries"): runs of vertices that are as they were are told by their places in the old boundary, all
/// others in full.
void put_boundary(const Boundary& now, const Boundary& before, VarintWriter&);

}  // namespace limpet::drawing
