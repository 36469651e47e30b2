// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <utility>
#include <vector>

#include "segment_internal.hpp"

namespace limpet::model::internal {

/// Where something has changed and is to be looked at again: a few boxes in the world. Only boxes near each
/// other are joined, so that two changes far apart do not call for a look at all that lies between them.
class DirtyRegion {
 public:
  DirtyRegion() = default;
  DirtyRegion(const Box3& place) { add(place); }  // NOLINT(google-explicit-constructor): a box is a region
  /// The region that has these boxes().
  static DirtyRegion of_boxes(std::vector<Box3> boxes) {
    DirtyRegion region;
    region.boxes_ = std::move(boxes);
    return region;
  }
  void add(const Box3& place);
  void add(const DirtyRegion& other) {
    for (const Box3& place : other.boxes_) add(place);
  }
  void clear() { boxes_.clear(); }
  bool empty() const { return boxes_.empty(); }
  const std::vector<Box3>& boxes() const { return boxes_; }

 private:
  std::vector<Box3> boxes_;
};

/// Calls f(slot) for segments near the region, maybe more than once for each, in no particular order.
template <class F>
void for_each_near(const SpatialIndex& index, const DirtyRegion& region, F&& f) {
  for (const Box3& box : region.boxes())
    index.any_of(box, [&](std::uint32_t slot) {
      f(slot);
      return false;
    });
}
/// Slots of segments near the region, in ascending order.
void query(const SpatialIndex&, const DirtyRegion&, std::vector<std::uint32_t>& found);
/// The places, in the world, of those of the edges that are still on the perimeter.
DirtyRegion region_of(const PolygonPart&, const PlacedEdges&);

}  // namespace limpet::model::internal
