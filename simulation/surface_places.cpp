// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/simulation/surface_places.hpp>

#include <algorithm>

namespace limpet::simulation {

using Eigen::Vector3d;

SurfacePlaces::SurfacePlaces(const Mesh& mesh) : mesh_(mesh) {
  double total = 0;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    area_up_to_.push_back(total += area_vector(mesh, t).norm());
  if (!(total > 0)) throw MeshError("the surface has no area");
}

SurfacePlaces::Place SurfacePlaces::next(survey::Random& random) const {
  const double area = random.uniform() * area_up_to_.back();
  const auto at = std::upper_bound(area_up_to_.begin(), area_up_to_.end() - 1, area);
  const int triangle = static_cast<int>(at - area_up_to_.begin());
  double s = random.uniform();
  double t = random.uniform();
  if (s + t > 1) {
    s = 1 - s;
    t = 1 - t;
  }
  const auto& [a, b, c] = mesh_.triangles[triangle];
  const Vector3d& origin = mesh_.vertices[a];
  return {origin + s * (mesh_.vertices[b] - origin) + t * (mesh_.vertices[c] - origin), triangle};
}

}  // namespace limpet::simulation
