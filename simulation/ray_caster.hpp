// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/simulation/mesh.hpp>
#include <memory>
#include <optional>

namespace limpet::simulation {

/// Finds what a ray meets first on a mesh, and how far the mesh is.
class RayCaster {
 public:
  explicit RayCaster(const Mesh& mesh);
  ~RayCaster();
  RayCaster(RayCaster&&) noexcept;
  RayCaster& operator=(RayCaster&&) noexcept;

  struct Hit {
    Eigen::Vector3d position;  ///< on the plane of the face
    double range = 0;          ///< from the ray's source
    int face = 0;
  };

  /// The first point of the surface along the ray, if the ray meets it from outside: a surface seen from its
  /// back hides what is behind it but gives no hit. Precondition: `direction` is a unit vector.
  std::optional<Hit> first_hit(const Eigen::Vector3d& source, const Eigen::Vector3d& direction) const;

  /// Distance from a place to the surface, to rounding; infinite when it has no area.
  double distance(const Eigen::Vector3d& from) const;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace limpet::simulation
