// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limpet/io/lifted.hpp>
#include <vector>

namespace limpet::io::internal {

/// A model as files for looking at have it: each polygon over vertices of its own, and its edges as lines.
struct DrawnModel {
  std::vector<LiftedPolygon> polygons;
  std::vector<Eigen::Vector3d> vertices;  ///< of all polygons' cycles, one after the other; welded: world
  struct Line {
    std::array<std::uint32_t, 2> ends;  ///< indices of vertices
    std::uint64_t segment = 0;          ///< the polygon that the edge is of
    std::uint64_t edge = 0, partner = 0;
  };
  std::vector<Line> lines;  ///< open edges, and of each corresponding pair the one of lower identity

  /// Index of the first vertex of each polygon.
  std::vector<std::uint32_t> first;
};

DrawnModel drawn(const model::ModelRecord&);

/// Triangles of a polygon, as indices of DrawnModel::vertices.
std::vector<std::array<std::uint32_t, 3>> triangles_of(const DrawnModel&, std::size_t polygon);

}  // namespace limpet::io::internal
