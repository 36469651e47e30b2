// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <limpet/simulation/mesh.hpp>
#include <optional>
#include <vector>

namespace limpet::simulation {

/// A rotation, told in one of three ways, or none.
struct Turn {
  std::optional<Eigen::Vector4d> quaternion;  ///< w, x, y, z, of any length but 0
  /// Roll, pitch and yaw in degrees: about the fixed x axis first, then y, then z.
  std::optional<Eigen::Vector3d> euler_deg;
  bool random = false;
};

/// The rotation; a random one by random_rotation(seed).
Eigen::Quaterniond rotation_of(const Turn&, std::uint64_t seed);

/// Where an object is put: scaled about its origin, then turned about it, then moved.
struct Placement {
  double scale = 1;  ///< > 0
  Turn turn;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

/// From the object's frame to the world's.
Eigen::Affine3d transform_of(const Placement&, std::uint64_t seed);

/// The mesh, moved; its faces stay as they are. Precondition: the transform does not mirror.
Mesh placed(Mesh, const Eigen::Affine3d&);
std::vector<Eigen::Vector3d> placed(std::vector<Eigen::Vector3d>, const Eigen::Affine3d&);

}  // namespace limpet::simulation
