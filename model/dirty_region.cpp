// Copyright the limpet authors. GPL-3.0-or-later.
#include "dirty_region_internal.hpp"

#include <algorithm>

namespace limpet::model::internal {

void DirtyRegion::add(const Box3& place) {
  constexpr std::size_t kMost = 32;
  if (place.isEmpty()) return;
  for (Box3& box : boxes_) {
    const Box3 both = box.merged(place);
    if (both.diagonal().norm() > box.diagonal().norm() + place.diagonal().norm()) continue;
    box = both;
    return;
  }
  if (boxes_.size() == kMost)
    boxes_.back().extend(place);
  else
    boxes_.push_back(place);
}

void query(const SpatialIndex& index, const DirtyRegion& places, std::vector<std::uint32_t>& found) {
  found.clear();
  for_each_near(index, places, [&](std::uint32_t slot) { found.push_back(slot); });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

DirtyRegion region_of(const PolygonPart& part, const PlacedEdges& edges) {
  DirtyRegion places;
  for (const auto& [slot, edge] : edges) {
    if (!part.perimeter.alive(slot)) continue;
    Box3 box(part.position(slot));
    places.add(box.extend(part.position(part.perimeter.next(slot))));
  }
  return places;
}

}  // namespace limpet::model::internal
