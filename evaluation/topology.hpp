// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/evaluation/judgement.hpp>
#include <limpet/model/record.hpp>
#include <limpet/simulation/mesh.hpp>
#include <string>
#include <vector>

namespace limpet::evaluation {

/// A boundary loop as its face's neighbours see it: straight sides in the loop's direction, the interior on
/// the left.
struct SideLoop {
  std::vector<Eigen::Vector3d> begins;  ///< where each side begins
  std::vector<int> beyond;  ///< the face or polygon beyond each side; −1: none, the side is open
};

/// All loops of all faces of a mesh. Facets of one face are one, and vertices in the middle of a side between
/// the same two faces are left out.
std::vector<std::vector<SideLoop>> side_loops(const simulation::Mesh& mesh);
/// All cycles of all polygons of a model, edge by edge.
std::vector<std::vector<SideLoop>> side_loops(const model::ModelRecord& record);

/// How a model's neighbour relation compares with the truth's.
struct TopologyReport {
  bool closed = false;  ///< no edge is open
  bool isomorphic =
      false;            ///< vertices, edges and faces correspond one to one; an open side may have many edges
  int faces = 0;        ///< true faces that have one polygon with the same sides
  int true_shared = 0;  ///< sides between two true faces, each counted once
  int shared = 0;       ///< of these, those whose two polygons share an edge
  int false_shared = 0;        ///< pairs of polygons that share an edge where the truth's faces have no side
  double vertex_distance = 0;  ///< the largest from a vertex between shared sides to the true one; of `faces`
  std::vector<std::string> faults{};  ///< one line each
};

/// `faces` is judge_faces() of the same model: it tells which polygon is which face.
TopologyReport judge_topology(const model::ModelRecord& record, const simulation::Mesh& truth,
                              const FacesReport& faces);

}  // namespace limpet::evaluation
