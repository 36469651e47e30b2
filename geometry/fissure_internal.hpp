// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include <limpet/geometry/types.hpp>

#include "small_vector_internal.hpp"

namespace limpet::geometry::internal {

enum class FissureType { I, II, III, IV, V, VI };

/// How a fissure among four consecutive vertices is filled: the vertices between `first` and `last` are
/// replaced by `foot`, if there is one, or by nothing.
struct Filling {
  FissureType type;
  std::size_t first = 0, last = 0;
  std::optional<Point2> foot;  ///< v5, rounded

  /// The region that is filled: along the removed edges, then back along the new edge.
  using Region = SmallVector<Point2, 5>;
  Region region(const std::array<Point2, 4>& v) const;
};

/// The fissure of this type among v1, v2, v3, v4 (thesis §2.5); types I to III look at v1, v2, v3 alone.
std::optional<Filling> find_fissure(FissureType, const std::array<Point2, 4>& v, double gap);

inline constexpr std::array kFissureOrder = {FissureType::IV, FissureType::V,  FissureType::VI,
                                             FissureType::I,  FissureType::II, FissureType::III};

}  // namespace limpet::geometry::internal
