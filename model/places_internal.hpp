// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <utility>
#include <vector>

#include "segment_internal.hpp"

namespace limpet::model::internal {

/// A few places in the world, as boxes. Near ones are joined, so that a change here and one far away do not
/// ask for a look at all that lies between.
class Places {
 public:
  Places() = default;
  Places(const Box3& place) { add(place); }  // NOLINT(google-explicit-constructor): one place is places
  /// What boxes() told.
  static Places of_boxes(std::vector<Box3> boxes) {
    Places places;
    places.boxes_ = std::move(boxes);
    return places;
  }
  void add(const Box3& place);
  void add(const Places& other) {
    for (const Box3& place : other.boxes_) add(place);
  }
  void clear() { boxes_.clear(); }
  bool empty() const { return boxes_.empty(); }
  const std::vector<Box3>& boxes() const { return boxes_; }

 private:
  std::vector<Box3> boxes_;
};

/// Slots of segments near the places, in ascending order.
void query(const SpatialIndex&, const Places&, std::vector<std::uint32_t>& found);
/// Where those of the edges lie that are still there.
Places places_of(const PolygonPart&, const PlacedEdges&);

}  // namespace limpet::model::internal
