// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/simulation/mesh.hpp>
#include <limpet/simulation/world.hpp>
#include <memory>
#include <optional>
#include <vector>

/// Range images of a fixed scanner as worlds for simulated range finders (thesis §4.2, §4.3). Positions are
/// in the world frame, in the scan's unit.
namespace limpet::simulation {

/// ε of thesis §4.2: of the distances from each point to the nearest other one, the largest. One point far
/// from all others makes it large. Throws MeshError when there are fewer than two points, one is not finite,
/// or it is 0 (no two different places).
double image_epsilon(const std::vector<Eigen::Vector3d>& points);

/// A range image as a world: of its points that are within ε of the sensing axis and at a distance of 0 to
/// the range along it, the one with the smallest distance is seen (thesis §4.2). `epsilon`: image_epsilon()
/// when not given.
///
/// A sight takes a walk along the axis through a grid. Without `direction` points have no front and no back,
/// as in the thesis. With it, the direction in which the scanner looked, each has a normal, that of the plane
/// through the points near it, which faces the scanner; then a point that is met from behind hides what is
/// behind it but gives no sighting, and the incidence is known.
///
/// Throws MeshError as image_epsilon() does (duplicates pass when ε is given), and when ε is not positive and
/// finite or `direction` is zero.
std::unique_ptr<World> make_range_image_world(std::vector<Eigen::Vector3d> points,
                                              std::optional<double> epsilon = std::nullopt,
                                              const std::optional<Eigen::Vector3d>& direction = std::nullopt);

/// What a scanner on one side sees of a mesh.
struct RangeImage {
  std::vector<Eigen::Vector3d> points;  ///< row by row
  std::vector<int> faces;               ///< the true face of each
};

/// The range image that a laser scanner far away makes of a mesh: one of parallel rays through each point of
/// a square grid of this pitch, across `direction` (any length but 0), where the ray meets the surface from
/// outside. Throws MeshError when the direction is zero, the pitch is not positive, there would be more than
/// 10⁸ rays, or no ray meets the surface.
RangeImage take_range_image(const Mesh&, const Eigen::Vector3d& direction, double pitch);

/// The true faces of which the image shows nothing, or almost: less than a twentieth of the points that a
/// look straight at all of the face would have given. A face of which it shows a part is not among them.
std::vector<int> occluded_faces(const Mesh&, const RangeImage&, double pitch);

}  // namespace limpet::simulation
