// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/simulation/ray_caster.hpp>
#include <limpet/simulation/world.hpp>

#include <vector>

namespace limpet::simulation {
namespace {

class MeshWorld : public World {
 public:
  explicit MeshWorld(const Mesh& mesh) : rays_(mesh) {
    for (const Face& face : faces_of(mesh)) normals_.push_back(face.normal);
  }

  std::optional<Sighting> sight(const Eigen::Vector3d& from, const Eigen::Vector3d& axis,
                                double range) const override {
    const auto hit = rays_.first_hit(from, axis);
    if (!hit || hit->range > range) return std::nullopt;
    return Sighting{hit->range, -axis.dot(normals_[static_cast<std::size_t>(hit->face)])};
  }

  bool meets(const Eigen::Vector3d& centre, double radius) const override {
    return rays_.distance(centre) <= radius;
  }

 private:
  RayCaster rays_;
  std::vector<Eigen::Vector3d> normals_;
};

}  // namespace

std::unique_ptr<World> make_mesh_world(const Mesh& mesh) { return std::make_unique<MeshWorld>(mesh); }

}  // namespace limpet::simulation
