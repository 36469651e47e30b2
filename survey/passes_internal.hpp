// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <limpet/survey/random.hpp>

namespace limpet::survey {

inline constexpr int kChanceBits = 10;  ///< of a sort key

/// A reading's sort key: the place of its cell on the curve, and below it a few bits by chance, so that the
/// readings of a cell are not in the rows of a raster. `place` of the reading in the scan.
inline std::uint64_t sort_key(std::uint64_t cell, std::int64_t place) {
  return cell << kChanceBits | mixed(static_cast<std::uint64_t>(place)) >> (64 - kChanceBits);
}

/// Tells to which pass over the scan a reading belongs; asked for one after the other in the order of their
/// keys.
class Passes {
 public:
  std::size_t pass_of(std::uint64_t key) {
    const std::uint64_t cell = key >> kChanceBits;
    before_ = cell == cell_ ? before_ + 1 : 0;
    cell_ = cell;
    return static_cast<std::size_t>(std::bit_width(before_ / kFirst));
  }

 private:
  /// The readings of a cell that come in the first pass; as many come in the second, twice as many in each
  /// one after.
  static constexpr std::uint64_t kFirst = 12;

  std::uint64_t cell_ = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t before_ = 0;  ///< readings of the cell that came before
};

}  // namespace limpet::survey
