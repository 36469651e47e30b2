// Copyright the limpet authors. GPL-3.0-or-later.
#include <map>
#include <numeric>

#include "engine_internal.hpp"

namespace limpet::model::internal {

std::vector<std::vector<SegmentId>> surfaces(const Engine& e) {
  std::vector<std::size_t> root(e.segments.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (const auto& [edge, entry] : e.shared)
    root[find(entry.segment)] = find(e.shared.at(entry.partner.value).segment);
  std::map<std::size_t, std::vector<SegmentId>> by_root;
  for (const auto& s : e.segments)
    if (s) by_root[find(s->slot)].push_back(s->id);
  std::vector<std::vector<SegmentId>> result;
  for (auto& [first, surface] : by_root) {
    std::sort(surface.begin(), surface.end());
    result.push_back(std::move(surface));
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace limpet::model::internal
