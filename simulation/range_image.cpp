// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/simulation/range_image.hpp>
#include <limpet/simulation/ray_caster.hpp>

#include <Eigen/Geometry>
#include <cmath>

namespace limpet::simulation {
namespace {

using Eigen::Vector3d;

constexpr double kMostRays = 1e8;
/// Of the pitch, where the first ray is: objects are symmetric and have edges at round places, so a ray in
/// the middle of the grid would run along them.
constexpr double kFirst = 0.381966;
/// A face with a smaller share of the points of a look straight at it is occluded.
constexpr double kAlmostNothing = 0.05;

/// The axes of an image, and the mesh's extent along them.
struct Frame {
  Eigen::Matrix3d axes;  ///< columns: right, up, forward
  Vector3d low, high;    ///< along each

  Vector3d at(double right, double up, double forward) const { return axes * Vector3d(right, up, forward); }
};

Frame frame_of(const Mesh& mesh, const Vector3d& direction) {
  Frame frame;
  const Vector3d forward = direction.normalized(), right = forward.unitOrthogonal();
  frame.axes << right, forward.cross(right), forward;
  frame.low = frame.high = frame.axes.transpose() * mesh.vertices.front();
  for (const Vector3d& v : mesh.vertices) {
    frame.low = frame.low.cwiseMin(frame.axes.transpose() * v);
    frame.high = frame.high.cwiseMax(frame.axes.transpose() * v);
  }
  return frame;
}

}  // namespace

RangeImage take_range_image(const Mesh& mesh, const Vector3d& direction, double pitch) {
  if (!(direction.allFinite() && direction.norm() > 0))
    throw MeshError("the direction in which a scanner looks must not be zero");
  if (!(pitch > 0)) throw MeshError("the pitch of a range image must be more than 0");
  const Frame frame = frame_of(mesh, direction);
  const Vector3d size = frame.high - frame.low;
  if (!((size.x() / pitch + 1) * (size.y() / pitch + 1) <= kMostRays))
    throw MeshError("a range image of this pitch would have more than 10⁸ rays: give a larger one");
  const RayCaster caster(mesh);
  const double before = frame.low.z() - size.norm();
  RangeImage image;
  for (double up = frame.low.y() + kFirst * pitch; up <= frame.high.y(); up += pitch) {
    for (double right = frame.low.x() + kFirst * pitch; right <= frame.high.x(); right += pitch) {
      const auto hit = caster.first_hit(frame.at(right, up, before), frame.axes.col(2));
      if (!hit) continue;
      image.points.push_back(hit->position);
      image.faces.push_back(hit->face);
    }
  }
  if (image.points.empty()) throw MeshError("nothing of the surface is seen from this side at this pitch");
  return image;
}

std::vector<int> occluded_faces(const Mesh& mesh, const RangeImage& image, double pitch) {
  std::vector<double> points(static_cast<std::size_t>(mesh.face_count), 0);
  for (const int face : image.faces) ++points[static_cast<std::size_t>(face)];
  const std::vector<Face> faces = faces_of(mesh);
  std::vector<int> occluded;
  for (std::size_t face = 0; face < faces.size(); ++face)
    if (points[face] * pitch * pitch < kAlmostNothing * faces[face].area)
      occluded.push_back(static_cast<int>(face));
  return occluded;
}

}  // namespace limpet::simulation
