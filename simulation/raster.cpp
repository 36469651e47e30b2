// Copyright the limpet authors. GPL-3.0-or-later.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <limpet/simulation/raster.hpp>

namespace limpet::simulation {

using Eigen::Vector2d;
using Eigen::Vector3d;

Raster::Raster(const Mesh& mesh, const std::vector<Vector3d>& viewpoints) : ScanPattern(mesh) {
  const Bounds bounds = bounds_of(mesh);
  for (const Vector3d& viewpoint : viewpoints) {
    if ((viewpoint.array() >= bounds.low.array()).all() && (viewpoint.array() <= bounds.high.array()).all())
      look_around(viewpoint);
    else
      look_at(mesh, viewpoint);
  }
}

/// One image, just wide enough for the mesh; or all around if part of the mesh is far to the side.
void Raster::look_at(const Mesh& mesh, const Vector3d& viewpoint) {
  Image image;
  image.viewpoint = viewpoint;
  image.forward = (bounds_of(mesh).centre() - viewpoint).normalized();
  const Vector3d sky = std::abs(image.forward.z()) < 0.9 ? Vector3d::UnitZ() : Vector3d::UnitY();
  image.right = image.forward.cross(sky).normalized();
  image.up = image.right.cross(image.forward);
  image.low.setConstant(std::numeric_limits<double>::max());
  image.high = -image.low;
  for (const Vector3d& vertex : mesh.vertices) {
    const Vector3d to = vertex - viewpoint;
    const double depth = to.dot(image.forward);
    if (depth < 0.3 * to.norm()) return look_around(viewpoint);
    const Vector2d seen(to.dot(image.right) / depth, to.dot(image.up) / depth);
    image.low = image.low.cwiseMin(seen);
    image.high = image.high.cwiseMax(seen);
  }
  images_.push_back(image);
}

/// Six images, the sides of a cube about the viewpoint.
void Raster::look_around(const Vector3d& viewpoint) {
  for (int side = 0; side < 6; ++side) {
    Image image;
    image.viewpoint = viewpoint;
    image.forward = side % 2 == 0 ? Vector3d::Unit(side / 2) : Vector3d(-Vector3d::Unit(side / 2));
    image.right = Vector3d::Unit((side / 2 + 1) % 3);
    image.up = image.right.cross(image.forward);
    image.low.setConstant(-1);
    image.high.setConstant(1);
    images_.push_back(image);
  }
}

void Raster::send(double pitch, const Send& send) const {
  double phase = 0;  // differs from image to image, so their pixels do not fall on one another
  for (const Image& image : images_) {
    phase += 0.6180339887498949;
    phase -= std::floor(phase);
    const Vector2d size = image.high - image.low;
    const std::int64_t columns = static_cast<std::int64_t>(size.x() / pitch + phase);
    const std::int64_t rows = static_cast<std::int64_t>(size.y() / pitch + 1 - phase);
    const Vector2d first =
        (image.low + image.high) / 2 -
        pitch / 2 * Vector2d(static_cast<double>(columns - 1), static_cast<double>(rows - 1));
    for (std::int64_t row = 0; row < rows; ++row) {
      for (std::int64_t step = 0; step < columns; ++step) {
        const std::int64_t column = row % 2 == 0 ? step : columns - 1 - step;
        const double x = first.x() + pitch * static_cast<double>(column);
        const double y = first.y() + pitch * static_cast<double>(row);
        send(image.viewpoint, (image.forward + x * image.right + y * image.up).normalized());
      }
    }
  }
}

double Raster::extent() const {
  double area = 0;
  for (const Image& image : images_) area += (image.high - image.low).prod();
  return area;
}

}  // namespace limpet::simulation
