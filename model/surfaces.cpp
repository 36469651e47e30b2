// Copyright the limpet authors. GPL-3.0-or-later.
#include <map>
#include <numeric>

#include "engine_internal.hpp"

namespace limpet::model::internal {

// Edges know whether they are shared, not with whom: until shared edges are formed every segment is a surface
// of its own (thesis §2.2).
std::vector<std::vector<SegmentId>> surfaces(const Engine& e) {
  std::vector<std::vector<SegmentId>> result;
  for (const auto& s : e.segments)
    if (s) result.push_back({s->id});
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace limpet::model::internal
