// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/io/color.hpp>
#include <limpet/io/lifted.hpp>
#include <vector>

namespace limpet::io {

/// A face of an exported mesh: vertices anticlockwise about the outward normal.
struct MeshFace {
  std::vector<int> vertices;
  std::uint64_t segment = 0;  ///< the polygon segment it is (a part of)
};

struct PolygonMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<MeshFace> faces;
};

/// The faces of a model over the vertices that weld() gives. Polygons with holes are triangulated, and with
/// `triangles_only` all others too; polygons whose perimeter has fewer than three vertices are left out.
PolygonMesh make_mesh(const std::vector<LiftedPolygon>& polygons, double reach, bool triangles_only);

}  // namespace limpet::io
