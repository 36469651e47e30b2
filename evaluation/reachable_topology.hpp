// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/evaluation/reachable.hpp>
#include <limpet/evaluation/topology.hpp>
#include <limpet/model/record.hpp>
#include <limpet/simulation/mesh.hpp>
#include <vector>

namespace limpet::evaluation {

/// How the neighbour relation of a model that a robot felt compares with the truth's.
struct ReachableTopology {
  int faces = 0;            ///< true faces that it is judged over
  bool isomorphic = false;  ///< vertices, edges and faces correspond one to one over these; false if none
  TopologyReport report;    ///< over these, renumbered in their order
};

/// The topology over the faces that are reachable to 99 % without doubt. Where there are others, these and
/// the polygons that lie on them are left out of both sides, and what was shared with them is open. A face is
/// asked for whole, and not for what a run happened to feel of it. Throws std::invalid_argument if λ is not
/// positive.
ReachableTopology judge_reachable_topology(const model::ModelRecord& model, const simulation::Mesh& truth,
                                           const Reachability& reachability, double resolution);

}  // namespace limpet::evaluation
