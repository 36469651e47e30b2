// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/simulation/mesh.hpp>
#include <memory>
#include <optional>

namespace limpet::simulation {

/// What simulated range finders and proximity switches see.
class World {
 public:
  virtual ~World() = default;

  /// What one range finder sees along its sensing axis.
  struct Sighting {
    double distance = 0;          ///< along the axis
    double incidence_cosine = 1;  ///< of the angle between the axis and the inward normal; 1 where unknown
    /// From the place on the axis at this distance to the surface point that is seen, at a right angle to the
    /// axis. Zero, but for a range image, whose points are near an axis and not on it. It must not be
    /// dropped: at an angle the place on the axis is off the surface by up to ε·tan θ, always to the same
    /// side.
    Eigen::Vector3d aside = Eigen::Vector3d::Zero();
  };
  /// The first surface within `range`, if it is seen from outside. Precondition: `axis` is a unit vector.
  virtual std::optional<Sighting> sight(const Eigen::Vector3d& from, const Eigen::Vector3d& axis,
                                        double range) const = 0;
  /// Is any of the surface within this ball, whichever of its sides is turned to the centre? Precondition:
  /// the radius is not negative.
  virtual bool meets(const Eigen::Vector3d& centre, double radius) const = 0;
};

/// A mesh as a world: rays are cast. The mesh is copied.
std::unique_ptr<World> make_mesh_world(const Mesh&);

}  // namespace limpet::simulation
