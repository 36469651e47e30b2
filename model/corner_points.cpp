// Copyright the limpet authors. GPL-3.0-or-later.
//
// Where a corner vertex is (thesis §2.7): where the lines of its two edges meet; but where these run on in
// one line, as two of the segments around the corner lie in one plane, the lines do not say where along them
// it is, and the planes of the whole ring do.
#include <Eigen/Eigenvalues>
#include <cmath>
#include <span>

#include "corners_internal.hpp"

namespace limpet::model::internal {
namespace {

using geometry::EdgeId;
using geometry::Plane;
using geometry::Point2;
using geometry::Slot;

/// The point nearest to the planes, as far as they determine it; else as near as may be to `near`.
Eigen::Vector3d point_of(std::span<const Plane> planes, const Eigen::Vector3d& near) {
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();
  for (const Plane& plane : planes) {
    squares += plane.normal * plane.normal.transpose();
    pull -= plane.height_of(near) * plane.normal;
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.compute(squares);
  Eigen::Vector3d point = near;
  for (int k = 0; k < 3; ++k) {
    const double weight = solver.eigenvalues()[k];
    if (weight < kDetermined * solver.eigenvalues()[2]) continue;
    const Eigen::Vector3d direction = solver.eigenvectors().col(k);
    point += direction.dot(pull) / weight * direction;
  }
  return point;
}

/// The place on the part's plane that is nearest to all planes of the ring. A ring of three has no others.
std::optional<Eigen::Vector3d> place_by_ring(const Complex& complex, const Ring& ring, const RingPart& part,
                                             const Eigen::Vector3d& near) {
  const auto& perimeter = part.segment->polygon->perimeter;
  const Plane own = part.segment->polygon->plane(),
              first = plane_across(complex, perimeter.node(part.before).edge),
              second = plane_across(complex, perimeter.node(part.after).edge);
  if (ring.closed && ring.parts.size() == 3) return common_point(part.line_before, second);
  std::vector<Plane> planes;
  for (const RingPart& other : ring.parts) planes.push_back(other.segment->polygon->plane());
  if (!ring.closed) planes.insert(planes.end(), {first, second});
  const Eigen::Vector3d point = point_of(planes, near);
  Eigen::Vector3d foot = point - own.height_of(point) * own.normal;
  const double reach = kRunsOnReach * complex.setting().least.lambda;
  if (std::abs(first.height_of(foot)) > reach || std::abs(second.height_of(foot)) > reach)
    return std::nullopt;
  return foot;
}

}  // namespace

std::optional<Eigen::Vector3d> place_of_corner(const Complex& complex, const Ring& ring,
                                               const RingPart& part) {
  const auto& polygon = *part.segment->polygon;
  if (run_on(polygon.perimeter, part.before, part.after, part.line_before, part.line_after))
    return place_by_ring(complex, ring, part, polygon.position(part.between.front()));
  return common_point(part.line_before, plane_across(complex, polygon.perimeter.node(part.after).edge));
}

std::optional<Eigen::Vector3d> place_of_corner(const Complex& complex, const Segment& s, Slot vertex,
                                               const CommonLine& line, EdgeId other,
                                               const Eigen::Vector3d& near) {
  const auto& perimeter = s.polygon->perimeter;
  const Slot before = perimeter.prev(vertex);
  const Plane beyond = plane_across(complex, other);
  const auto second = common_line(s.polygon->plane(), beyond, near);
  if (!second || !run_on(perimeter, before, vertex, line, *second)) return common_point(line, beyond);
  const Ring ring = ring_from(complex, s, before);
  return ring.parts.empty() ? std::nullopt : place_by_ring(complex, ring, ring.parts.front(), near);
}

}  // namespace limpet::model::internal
