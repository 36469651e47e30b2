// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/simulation/random_start.hpp>
#include <limpet/simulation/ray_caster.hpp>
#include <limpet/simulation/surface_places.hpp>

#include <cmath>

namespace limpet::simulation {
namespace {

constexpr int kTries = 10'000;
constexpr double kRounding = 1e-6;  ///< of the distance

}  // namespace

Eigen::Vector3d random_start(const Mesh& mesh, double distance, std::uint64_t seed,
                             const std::function<bool(const Eigen::Vector3d&)>& good) {
  if (!(distance > 0 && std::isfinite(distance)))
    throw MeshError("the distance of a start from the surface must be more than 0");
  const SurfacePlaces places(mesh);
  const RayCaster surface(mesh);
  survey::Random random(seed ^ 0x7374617274737461u);
  for (int i = 0; i < kTries; ++i) {
    const auto [place, triangle] = places.next(random);
    const Eigen::Vector3d start = place + distance * area_vector(mesh, triangle).normalized();
    if (surface.distance(start) < (1 - kRounding) * distance) continue;
    if (!good || good(start)) return start;
  }
  throw MeshError(
      "no place of the surface is found that can be seen and has this much room in front of it: give a "
      "smaller "
      "distance");
}

Eigen::Quaterniond random_rotation(std::uint64_t seed) {
  survey::Random random(seed ^ 0x726f746174696f6eu);
  Eigen::Vector4d turn;  // four normal numbers have no direction that they like better
  for (double& x : turn) x = random.normal();
  return Eigen::Quaterniond(turn.normalized());
}

}  // namespace limpet::simulation
