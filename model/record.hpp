// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limpet/model/parameters.hpp>
#include <string>
#include <vector>

namespace limpet::model {

__extension__ typedef __int128 Int128;

/// Exact sums over the sensor points a segment represents, in units of the model's grid step
/// (thesis §2.2, "model segment data").
struct MomentsRecord {
  std::int64_t count = 0;
  std::array<Int128, 3> sum{};      ///< Σx, Σy, Σz
  std::array<Int128, 6> product{};  ///< Σxx, Σxy, Σxz, Σyy, Σyz, Σzz
};

/// A sensor point kept by a young segment: grid coordinates, sensing axis (unit vector into the surface), and
/// how often it was in a segment that was dissolved.
struct RawPointRecord {
  std::array<std::int64_t, 3> at{};
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  int returned = 0;
};

struct PointSegmentRecord {
  std::uint64_t id = 0;
  MomentsRecord moments;
  Eigen::Vector3d axis_sum = Eigen::Vector3d::Zero();
  std::vector<RawPointRecord> raw;
  double variance_sum = 0;  ///< Σ of its points' noise variances; 0 unless the noise grows with the range
};

/// A vertex and the edge from it to the next one. x, y are chart coordinates in grid steps (whole numbers,
/// except in the build "float").
struct VertexRecord {
  double x = 0, y = 0;
  std::uint64_t edge = 0;     ///< identity of the edge from this vertex to the next
  std::uint64_t partner = 0;  ///< identity of the corresponding shared edge; 0: not shared
};

struct PolygonSegmentRecord {
  std::uint64_t id = 0;
  MomentsRecord moments;
  Eigen::Vector3d axis_sum = Eigen::Vector3d::Zero();
  /// Chart frame in the world: origin (scan's unit), orthonormal axes u, v and outward normal u × v.
  Eigen::Vector3d chart_origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d chart_u = Eigen::Vector3d::UnitX();
  Eigen::Vector3d chart_v = Eigen::Vector3d::UnitY();
  Eigen::Vector3d chart_normal = Eigen::Vector3d::UnitZ();
  /// Published plane as a height over the chart, in grid steps: h(x, y) = height[0] + height[1]·x +
  /// height[2]·y. The world position of a vertex is chart_origin + step·(x·u + y·v + h(x, y)·normal).
  std::array<double, 3> height{};
  Eigen::Vector3d initial_centroid = Eigen::Vector3d::Zero();
  Eigen::Vector3d initial_normal = Eigen::Vector3d::UnitZ();
  std::int64_t confirmed = 0;  ///< readings that lie on it; 0 unless it is an initial segment
  /// Boundary cycles, interior on the left: the outer perimeter (anticlockwise) first, then the holes
  /// (clockwise).
  std::vector<std::vector<VertexRecord>> cycles;
  std::vector<RawPointRecord> raw;
  double variance_sum = 0;  ///< Σ of its points' noise variances; 0 unless the noise grows with the range
};

/// A whole model as plain data: the contents of the native file (docs/native_format.md).
struct ModelRecord {
  Parameters parameters;     ///< of the model
  double grid_step = 0;      ///< a power of two, scan's unit
  std::string arithmetic;    ///< "exact", "float-grid" or "float"
  std::int64_t points = 0;   ///< sensor points accepted
  std::int64_t refused = 0;  ///< readings that were no point (Model::update())
  std::int64_t expired = 0;  ///< sensor points given up (see Counts)
  std::int64_t sets = 0;     ///< sets of sensor points processed
  /// Redundant segments that were deleted: by ψ and φ, and by position (thesis §2.9).
  std::int64_t redundant_by_count = 0, redundant_by_position = 0;
  std::uint64_t next_segment = 1, next_edge = 1;       ///< lowest identities not yet used
  std::vector<PointSegmentRecord> point_segments;      ///< ascending id
  std::vector<PolygonSegmentRecord> polygon_segments;  ///< ascending id
};

}  // namespace limpet::model
