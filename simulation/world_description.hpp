// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limpet/model/model.hpp>
#include <limpet/simulation/mesh.hpp>
#include <limpet/simulation/placement.hpp>
#include <limpet/simulation/world.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace limpet::simulation {

/// A world for a robot to follow, and what it knows of it beforehand, as plain data. Lengths are in the
/// world's unit, after placing.
struct WorldDescription {
  std::string mesh;     ///< name of a shape, or of a mesh file; empty: `image`
  std::string image;    ///< name of a scan whose points are a range image (thesis §4.2)
  Placement placement;  ///< of the mesh or the image

  /// The direction in which a scanner looked at the object, in the object's frame: where it is known, the
  /// points of an image have a front and a back, unless they are to be `two_sided` as the thesis's.
  std::optional<Eigen::Vector3d> direction;
  /// With a mesh: the robot's sensors see a range image of it (take_range_image()) from this direction.
  std::optional<double> pitch;
  bool two_sided = false;
  std::optional<double> epsilon;  ///< ε of an image; image_epsilon() when not given

  /// Initial model segments (thesis §4.3). At most one is given.
  std::string initial_mesh;        ///< the faces of a mesh file, placed as the object is
  std::vector<int> initial_faces;  ///< faces of the mesh
  bool initial_occluded = false;   ///< the faces of the mesh that its range image does not show
};

/// What became of a description.
struct BuiltWorld {
  std::unique_ptr<World> world;
  std::optional<Mesh> truth;           ///< placed; none of a range image from a file
  std::vector<Eigen::Vector3d> image;  ///< placed; empty when the sensors see the mesh itself
  std::vector<model::InitialFace> initial;
};

/// Throws MeshError or io::InputError when a file cannot be read, MeshError when something is asked of an
/// image or a mesh that is not there, or make_range_image_world() or take_range_image() do. `seed` is for a
/// random turn.
BuiltWorld build_world(const WorldDescription&, std::uint64_t seed);

/// A random start (random_start()) from which the world is seen: at this distance from the mesh, and of a
/// range image, near a part of the mesh that it shows. Throws MeshError when there is none, or no mesh.
Eigen::Vector3d random_start(const BuiltWorld&, double distance, std::uint64_t seed);

}  // namespace limpet::simulation
