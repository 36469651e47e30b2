// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/simulation/axis_grid_internal.hpp>
#include <limpet/simulation/range_image.hpp>
#include <limpet/simulation/range_image_internal.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace limpet::simulation {
namespace {

using Eigen::Vector3d;

/// Cosines of incidence down to this are those of a front: the normals are estimates.
constexpr double kBehind = -0.1;

class RangeImageWorld : public World {
 public:
  RangeImageWorld(std::vector<Vector3d> points, std::vector<Vector3d> normals, double epsilon)
      : points_(std::move(points)), normals_(std::move(normals)), grid_(points_, epsilon) {}

  std::optional<Sighting> sight(const Vector3d& from, const Vector3d& axis, double range) const override {
    const auto found = grid_.first(from, axis, range);
    if (!found) return std::nullopt;
    const double cosine = normals_.empty() ? 1 : -axis.dot(normals_[found->point]);
    if (cosine < kBehind) return std::nullopt;
    return Sighting{found->distance, std::max(0.0, cosine),
                    points_[found->point] - (from + found->distance * axis)};
  }

  bool meets(const Vector3d& centre, double radius) const override { return grid_.meets(centre, radius); }

 private:
  std::vector<Vector3d> points_, normals_;
  AxisGrid grid_;
};

}  // namespace

std::unique_ptr<World> make_range_image_world(std::vector<Vector3d> points, std::optional<double> epsilon,
                                              const std::optional<Vector3d>& direction) {
  require_image(points);
  if (epsilon && !(*epsilon > 0 && std::isfinite(*epsilon)))
    throw MeshError("ε of a range image must be more than 0");
  if (direction && !(direction->allFinite() && direction->norm() > 0))
    throw MeshError("the direction in which a scanner looks must not be zero");
  const double reach = epsilon ? *epsilon : image_epsilon(points);
  std::vector<Vector3d> normals;
  if (direction) normals = image_normals(points, direction->normalized());
  return std::make_unique<RangeImageWorld>(std::move(points), std::move(normals), reach);
}

}  // namespace limpet::simulation
