// Copyright the limpet authors. GPL-3.0-or-later.
#include "surface_lookup_internal.hpp"

namespace limpet::model::internal {

void surface_members(const Engine& e, SegmentId id, std::vector<SegmentId>& found) {
  found.clear();
  for (const auto& surface : surfaces(e))
    if (std::binary_search(surface.begin(), surface.end(), id)) found = surface;
}

SegmentId surface_of(const Engine& e, SegmentId id) {
  std::vector<SegmentId> members;
  surface_members(e, id, members);
  return members.empty() ? SegmentId{} : members.front();
}

}  // namespace limpet::model::internal
