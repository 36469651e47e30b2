// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace limpet::io {

/// Three vertices, anticlockwise, as indices into the concatenated cycles.
using Triangle = std::array<int, 3>;

/// Constrained Delaunay triangles of a polygon with holes, given as boundary cycles in its plane. Their areas
/// add up to the polygon's. Inside is where an odd number of cycles has been crossed, so their direction does
/// not matter. Precondition: the cycles are simple and do not cross; where they do, the triangles at the
/// crossings are left out. Cycles of fewer than three vertices bound nothing; of a polygon with a number that
/// is not finite nothing is made.
std::vector<Triangle> triangulate(const std::vector<std::vector<Eigen::Vector2d>>& cycles);

/// The corners of a triangle in its plane, anticlockwise.
using FlatTriangle = std::array<Eigen::Vector2d, 3>;

/// The same for cycles that may touch and cross, as those of a polygon to be judged: what lies inside an odd
/// number of them is covered to its last corner, those where two cycles cross included. Precondition: every
/// number is finite.
std::vector<FlatTriangle> triangulate_crossing(const std::vector<std::vector<Eigen::Vector2d>>& cycles);

}  // namespace limpet::io
