// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <limpet/model/rules.hpp>
#include <vector>

namespace limpet::model {

/// Of a resolution that grows with the range: its growth, and the places that it grows from.
inline constexpr double kMostResolutionGrowth = 0.25;
inline constexpr std::size_t kMostSensors = 64;

/// The parameters of a model. Lengths are in the scan's unit.
struct Parameters {
  double resolution = 0.05;  ///< λ: gaps smaller than this are not represented; > 0
  /// Growth of λ per unit of the distance to the nearest of `sensors`, for scanners that stand still and send
  /// their rays at equal angles; 0 to kMostResolutionGrowth, dimensionless.
  double resolution_per_range = 0;
  std::vector<Eigen::Vector3d>
      sensors;  ///< where scanners stood, where λ grows from (world); at most kMostSensors
  double angle_rad = 0.17453292519943295;  ///< μ: angles smaller than this are not told apart; in (0, π/2)
  double noise = 0;                        ///< standard deviation of a reading along its axis; ≥ 0
  double noise_per_range = 0;              ///< growth of the noise per unit of range; ≥ 0, dimensionless
  /// Growth of the noise with the square of the range, as of depths from triangulation; ≥ 0, one over the
  /// scan's unit.
  double noise_per_range2 = 0;
  double input_quantum = 0;  ///< the step to which the scan's own coordinates are rounded; ≥ 0
  double tolerance = 0;  ///< how far a surface may be from its plane; 0: 3 standard deviations of the noise
  /// A point segment of fewer than five points that none of this many later sensor points has joined is given
  /// up as outliers.
  std::int64_t outlier_patience = 1'000'000;
  /// ψ and φ (thesis §2.9): a segment is redundant when it has fewer than ψ points, fewer than φ times the
  /// points of a segment near it, and finds no edge to share with that segment.
  double redundancy_count = 20, redundancy_ratio = 0.05;
  bool neighbours = true;  ///< form shared edges and corner vertices (thesis §2.6, §2.7)
  Rules rules;
};

}  // namespace limpet::model
