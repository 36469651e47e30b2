// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <limpet/kinematics/posture.hpp>
#include <limpet/simulation/world_description.hpp>
#include <optional>

namespace limpet::app {

/// How an arm stands beside an object at the beginning of a run.
struct ArmPlacement {
  kinematics::Robot robot;  ///< its base where it stands in the world
  kinematics::Configuration start;
};

/// Where the object is, as seen from the arm's base, whose z axis points up.
enum class ObjectPlace {
  on_ground,  ///< both stand on the same ground
  in_reach    ///< the object is held up in the middle of the arm's reach, so that it can be felt from below,
              ///< too
};

/// What an arm's placement has to keep. Lengths in the scan's unit.
struct PlacementOptions {
  ObjectPlace object_place = ObjectPlace::in_reach;
  double follow_distance = 0.1;          ///< δ: of the control point from the surface at the start
  double link_distance = 0.1;            ///< what all links are to keep from the object at the start; > 0
  double own_distance = 0.02;            ///< and from each other
  double spared = 0.1;                   ///< radius of what of the control point's link is left out
  std::optional<Eigen::Vector3d> start;  ///< of the control point; none: by the seed
  /// The configuration that is tried first wherever the arm stands, its control point led to the start from
  /// there; none: all are drawn at random.
  std::optional<kinematics::Configuration> posture;
  std::uint64_t seed = 1;
};

/// Stands an arm beside an object, at a distance and a bearing by the seed (beside a range image on the side
/// that it shows, to 60°), its x axis turned towards the
/// object to 60°, such that the object's middle is well within reach; and finds a configuration in which its
/// control point is δ in front of the surface (simulation::random_start(), of a range image near a part that
/// it shows; or where it is told to be), a sensor of its link meets the surface, and all of it is clear of
/// the object and of itself. Of a range image from a file, the object is its points and the faces known
/// beforehand. The same arguments give the same placement. Throws simulation::MeshError when none is found,
/// saying what would help, and as random_start() does.
ArmPlacement place_beside(const kinematics::Robot&, const simulation::BuiltWorld&, const PlacementOptions&);

/// How far the control point can be from where the first joint that moves is mounted: the farthest of many
/// configurations drawn at random, always the same.
double reach_of(const kinematics::Robot&);

}  // namespace limpet::app
