// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limpet/io/lifted.hpp>
#include <vector>

namespace limpet::io {

/// The vertices of a model as one polyhedron has them. Lifted vertices are numbered through all cycles of all
/// polygons.
struct WeldedVertices {
  std::vector<int> welded;          ///< of each lifted vertex, the welded one it is
  std::vector<Eigen::Vector3d> at;  ///< of each welded vertex: world, scan's unit
  std::int64_t corners = 0;         ///< of them, those that three polygons or more have in common
  double corner_distance = 0;       ///< the largest from such a vertex to one of its planes, scan's unit
};

/// Vertices are one where the ends of corresponding shared edges meet: by identity, not by nearness (a pair
/// further apart than `reach`, which no sound model has, stays two). Where the planes at a corner do not meet
/// in a point, it lies where the sum of the squared distances from them is least.
WeldedVertices weld(const std::vector<LiftedPolygon>& polygons, double reach);

}  // namespace limpet::io
