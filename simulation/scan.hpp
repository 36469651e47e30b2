// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <limpet/model/sensor_point.hpp>
#include <limpet/simulation/mesh.hpp>
#include <vector>

namespace limpet::simulation {

/// How a simulated scan is taken. Lengths are in the scan's unit.
struct ScanOptions {
  enum class Order {
    raster,    ///< images from each viewpoint in turn, row by row, every other row backwards
    turning,   ///< at equal angles from each viewpoint in turn (TurningScanner)
    shuffled,  ///< raster's readings in random order (all are kept in memory)
    sampled    ///< uniform over the surface's area, hidden or not, in random order; needs no viewpoint
  };

  std::int64_t points = 0;  ///< wanted; exact if sampled, about (within 5 % from 1000 on) if not
  Order order = Order::raster;
  double noise = 0;            ///< standard deviation of a reading along its sensing axis
  double noise_per_range = 0;  ///< added to `noise` times the distance from the viewpoint (not if sampled)
  double outliers = 0;         ///< fraction of readings, 0 to 1, that are replaced by points anywhere
  std::uint64_t seed = 1;
  /// Where the sensor stands. Empty: around the mesh (viewpoints_around, with faces). One within the mesh's
  /// bounding box looks all around, others at the mesh.
  std::vector<Eigen::Vector3d> viewpoints;
};

/// A reading that knows which true face it was taken from.
struct LabelledPoint {
  model::SensorPoint point;
  int face = 0;  ///< index of a face of the mesh; −1: an outlier
};

/// Simulates a scan and hands its readings, one at a time, to `take`.
///
/// Raster: one ray a pixel, at the same angular pitch from every viewpoint; a ray that meets nothing, or a
/// surface from its back, gives no reading. The sensing axis is the ray's direction. Turning: the same with
/// rays at equal angles. Sampled: the axis is the face's inward normal tilted at random by up to 30°.
/// Gaussian noise moves a reading along its axis. An outlier is uniform in the mesh's bounding box grown by
/// 10 % of its size on each side (10 % of its diagonal where it is flat); its axis is kept.
///
/// The same mesh, options and seed give the same bytes; a shuffled scan is a permutation of the raster scan
/// with the same options. Memory: none for the readings unless shuffled. Throws std::invalid_argument on
/// options out of range, MeshError if the surface cannot be seen or has no area.
void scan(const Mesh& mesh, const ScanOptions& options,
          const std::function<void(const LabelledPoint&)>& take);

/// The same, collected.
std::vector<LabelledPoint> scan(const Mesh& mesh, const ScanOptions& options);

}  // namespace limpet::simulation
