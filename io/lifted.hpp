// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limpet/model/record.hpp>
#include <vector>

namespace limpet::io {

/// A vertex in the world, with the edge that leaves it anticlockwise.
struct LiftedVertex {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();     ///< world, scan's unit
  Eigen::Vector2d chart = Eigen::Vector2d::Zero();  ///< the same vertex in its segment's chart, grid steps
  std::uint64_t edge = 0;                           ///< identity of the edge to the next vertex
  std::uint64_t partner = 0;                        ///< identity of the corresponding shared edge; 0: open
  bool shared() const { return partner != 0; }
};

using LiftedCycle = std::vector<LiftedVertex>;

/// A polygon segment as it stands in the world.
struct LiftedPolygon {
  std::uint64_t id = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit outward normal of the published plane
  std::int64_t points = 0;                            ///< sensor points the segment represents
  std::vector<LiftedCycle> cycles;                    ///< interior on the left: the perimeter, then the holes
};

/// Lifts every polygon segment onto its published plane, in the record's order.
std::vector<LiftedPolygon> lift(const model::ModelRecord& model);

/// Where a point segment is: the mean of its sensor points, world, scan's unit. Precondition: moments.count >
/// 0.
Eigen::Vector3d centroid(const model::MomentsRecord& moments, double grid_step);

/// Area of the polygon (holes subtracted), in the square of the scan's unit.
double area(const LiftedPolygon& polygon);

}  // namespace limpet::io
