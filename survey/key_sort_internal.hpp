// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <vector>

namespace limpet::survey {

/// What a reading is sorted by: its place on the curve, and which of those held in memory it is.
struct SortKey {
  std::uint64_t key;
  std::uint32_t index;
};

/// Sorts by `key`; what has the same key keeps its order (radix sort, the least digit first).
void sort_by_key(std::vector<SortKey>& keys);

}  // namespace limpet::survey
