// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/simulation/placement.hpp>
#include <limpet/simulation/random_start.hpp>

#include <numbers>
#include <utility>

namespace limpet::simulation {

using Eigen::Vector3d;

Eigen::Quaterniond rotation_of(const Turn& turn, std::uint64_t seed) {
  if (turn.random) return random_rotation(seed);
  if (turn.quaternion) {
    const Eigen::Vector4d q = turn.quaternion->normalized();
    return {q[0], q[1], q[2], q[3]};
  }
  const Vector3d angle = turn.euler_deg.value_or(Vector3d::Zero()) * std::numbers::pi / 180;
  return Eigen::AngleAxisd(angle.z(), Vector3d::UnitZ()) * Eigen::AngleAxisd(angle.y(), Vector3d::UnitY()) *
         Eigen::AngleAxisd(angle.x(), Vector3d::UnitX());
}

Eigen::Affine3d transform_of(const Placement& placement, std::uint64_t seed) {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  transform.linear() = placement.scale * rotation_of(placement.turn, seed).toRotationMatrix();
  transform.translation() = placement.position;
  return transform;
}

Mesh placed(Mesh mesh, const Eigen::Affine3d& transform) {
  mesh.vertices = placed(std::move(mesh.vertices), transform);
  return mesh;
}

std::vector<Vector3d> placed(std::vector<Vector3d> points, const Eigen::Affine3d& transform) {
  for (Vector3d& p : points) p = transform * p;
  return points;
}

}  // namespace limpet::simulation
