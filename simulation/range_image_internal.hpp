// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace limpet::simulation {

/// Throws MeshError when there are fewer than two points, or one is not finite.
void require_image(const std::vector<Eigen::Vector3d>& points);

/// The outward normal at each point of a range image: of the plane of best fit to the points nearest to it,
/// turned against `direction`, in which the scanner looked (unit vector). Where these points are nearly in a
/// line, against `direction` itself.
std::vector<Eigen::Vector3d> image_normals(const std::vector<Eigen::Vector3d>& points,
                                           const Eigen::Vector3d& direction);

}  // namespace limpet::simulation
