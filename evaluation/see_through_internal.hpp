// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <limpet/evaluation/footing_internal.hpp>
#include <limpet/model/sensor_point.hpp>
#include <vector>

namespace limpet::evaluation {

/// Rays from where the sensor stood to its readings, counted by polygon.
struct RayCounts {
  std::int64_t rays = 0;
  std::vector<std::int64_t> on, through;
};

/// Follows at most `most` rays of the readings that know their range, evenly taken.
///
/// A ray passes through a polygon that it crosses more than λ before its reading and more than λ inside the
/// perimeter, which may lie that far off, when the reading is off the polygon's plane by more than its
/// tolerance, and no outlier: five readings at least, itself among them, are within a cube of 3λ.
RayCounts see_through(const std::vector<Ground>& grounds, const Footing& footing, const Tolerance& tolerance,
                      const std::vector<model::SensorPoint>& readings, const ResolutionField& resolution,
                      std::int64_t most);

}  // namespace limpet::evaluation
