// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <limpet/kinematics/posture.hpp>
#include <limpet/simulation/mesh.hpp>
#include <optional>

namespace limpet::app {

/// How an arm stands beside an object at the beginning of a run.
struct ArmPlacement {
  kinematics::Robot robot;  ///< its base where it stands in the world
  kinematics::Configuration start;
};

/// What an arm's placement has to keep. Lengths in the scan's unit.
struct PlacementOptions {
  double follow_distance = 0.1;          ///< δ: of the control point from the surface at the start
  double link_distance = 0.1;            ///< what all links are to keep from the surface at the start; > 0
  double own_distance = 0.02;            ///< and from each other
  double spared = 0.1;                   ///< radius of what of the control point's link is left out
  std::optional<Eigen::Vector3d> start;  ///< of the control point; none: by the seed
  std::uint64_t seed = 1;
};

/// Stands an arm on the ground that the object stands on, beside it: at a distance and a bearing by the seed,
/// such that the object's middle is well within reach; and finds a configuration in which its control point
/// is δ in front of the surface and all of it is clear, of many drawn at random. The same arguments give the
/// same placement. Throws simulation::MeshError when none is found.
ArmPlacement place_beside(const kinematics::Robot&, const simulation::Mesh& object, const PlacementOptions&);

}  // namespace limpet::app
