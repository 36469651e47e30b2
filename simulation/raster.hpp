// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <limpet/simulation/mesh.hpp>
#include <limpet/simulation/ray_caster.hpp>
#include <vector>

namespace limpet::simulation {

/// Perspective images of a mesh from several viewpoints, all at the same pitch: the distance between
/// neighbouring pixels in an image plane one unit in front of the viewpoint.
class Raster {
 public:
  Raster(const Mesh& mesh, const std::vector<Eigen::Vector3d>& viewpoints);

  using Take = std::function<void(const RayCaster::Hit&, const Eigen::Vector3d& direction)>;

  /// All hits, image by image, row by row, every other row backwards.
  void sweep(double pitch, const Take& take) const;

  /// A pitch that gives about so many hits. Throws MeshError if no viewpoint sees the surface.
  double pitch_for(std::int64_t points) const;

 private:
  struct Image {
    Eigen::Vector3d viewpoint, forward, right, up;
    Eigen::Vector2d low, high;  ///< extent in the image plane
  };

  void look_at(const Mesh& mesh, const Eigen::Vector3d& viewpoint);
  void look_around(const Eigen::Vector3d& viewpoint);
  std::int64_t count(double pitch) const;

  RayCaster caster_;
  std::vector<Image> images_;
};

}  // namespace limpet::simulation
