// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limpet/model/record.hpp>
#include <limpet/simulation/mesh.hpp>
#include <vector>

namespace limpet::evaluation {

using Triangle3 = std::array<Eigen::Vector3d, 3>;

/// A planar polygon in space with holes, whoever made it: what is judged. World frame, scan's unit.
struct PlanarFace {
  std::uint64_t id = 0;  ///< its name in reports
  /// Boundary cycles, in any order and direction: what lies inside an odd number of them is interior.
  std::vector<std::vector<Eigen::Vector3d>> cycles;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, outward
  std::int64_t points = 0;                            ///< sensor points it represents; 0: not known
};

/// The polygon segments of a model, lifted into space (docs/native_format.md), in their order.
std::vector<PlanarFace> planar_faces(const model::ModelRecord& record);

/// The true faces of a mesh, in their order, as polygons: id is the face's index.
std::vector<PlanarFace> planar_faces(const simulation::Mesh& mesh);

/// The interior as triangles, facing along the normal. Empty if there is none (fewer than three
/// vertices, no extent). Cycles that cross are cut where they cross.
std::vector<Triangle3> triangulated(const PlanarFace& face);

}  // namespace limpet::evaluation
