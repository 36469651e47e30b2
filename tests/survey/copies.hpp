// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <array>
#include <cstdint>
#include <limpet/model/sensor_point.hpp>
#include <limpet/survey/random.hpp>
#include <utility>
#include <vector>

namespace limpet::testing {

/// How the copies of a scan's points lie in it.
enum class Copies { in_a_row, one_after_the_other, shuffled };
inline constexpr std::array<Copies, 3> kAllCopies = {Copies::in_a_row, Copies::one_after_the_other,
                                                     Copies::shuffled};

inline void shuffle(std::vector<model::SensorPoint>& points, std::uint64_t seed) {
  survey::Random random(seed);
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random.below(i)]);
}

/// Each point three times.
inline std::vector<model::SensorPoint> thrice(const std::vector<model::SensorPoint>& points, Copies order,
                                              std::uint64_t seed) {
  std::vector<model::SensorPoint> copies;
  if (order == Copies::in_a_row) {
    for (const auto& point : points) copies.insert(copies.end(), 3, point);
    return copies;
  }
  for (int i = 0; i < 3; ++i) copies.insert(copies.end(), points.begin(), points.end());
  if (order == Copies::shuffled) shuffle(copies, seed);
  return copies;
}

}  // namespace limpet::testing
