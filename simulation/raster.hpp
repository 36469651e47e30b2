// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/simulation/scan_pattern.hpp>
#include <vector>

namespace limpet::simulation {

/// Perspective images of a mesh from several viewpoints, image by image, row by row, every other row
/// backwards. The pitch is the distance between neighbouring pixels in an image plane one unit in front of
/// the viewpoint.
class Raster : public ScanPattern {
 public:
  Raster(const Mesh& mesh, const std::vector<Eigen::Vector3d>& viewpoints);

 private:
  struct Image {
    Eigen::Vector3d viewpoint, forward, right, up;
    Eigen::Vector2d low, high;  ///< extent in the image plane
  };

  void look_at(const Mesh& mesh, const Eigen::Vector3d& viewpoint);
  void look_around(const Eigen::Vector3d& viewpoint);
  void send(double pitch, const Send&) const override;
  double extent() const override;

  std::vector<Image> images_;
};

}  // namespace limpet::simulation
