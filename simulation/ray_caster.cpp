// Copyright the limpet authors. GPL-3.0-or-later.
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <limits>
#include <limpet/simulation/ray_caster.hpp>

namespace limpet::simulation {
namespace {

using Eigen::Vector3d;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 point(const Vector3d& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace

struct RayCaster::Inside {
  Triangles triangles;
  std::vector<int> face_of;  ///< of each triangle kept
  std::vector<Face> faces;
  Tree tree;
};

RayCaster::RayCaster(const Mesh& mesh) : inside_(std::make_unique<Inside>()) {
  inside_->faces = faces_of(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Kernel::Triangle_3 triangle(point(mesh.vertices[a]), point(mesh.vertices[b]),
                                      point(mesh.vertices[c]));
    if (triangle.is_degenerate()) continue;
    inside_->triangles.push_back(triangle);
    inside_->face_of.push_back(mesh.face_of_triangle[t]);
  }
  inside_->tree.insert(inside_->triangles.cbegin(), inside_->triangles.cend());
  inside_->tree.build();
}

RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&&) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&&) noexcept = default;

std::optional<RayCaster::Hit> RayCaster::first_hit(const Vector3d& source, const Vector3d& direction) const {
  const Kernel::Ray_3 ray(point(source), Kernel::Vector_3(direction.x(), direction.y(), direction.z()));
  const auto met = inside_->tree.first_intersected_primitive(ray);
  if (!met) return std::nullopt;
  const int face = inside_->face_of[static_cast<std::size_t>(*met - inside_->triangles.cbegin())];
  const Face& plane = inside_->faces[face];
  const double approach = direction.dot(plane.normal);
  if (approach >= 0) return std::nullopt;
  const double range = (plane.centroid - source).dot(plane.normal) / approach;
  return Hit{source + range * direction, range, face};
}

double RayCaster::distance(const Vector3d& from) const {
  if (inside_->tree.empty()) return std::numeric_limits<double>::infinity();
  return std::sqrt(inside_->tree.squared_distance(point(from)));
}

}  // namespace limpet::simulation
