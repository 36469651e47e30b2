// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limpet/model/view.hpp>
#include <vector>

namespace limpet::kinematics {

/// A capsule that holds all the points, and so their convex hull, with nearly the smallest volume: along the
/// best of many directions, as long and as thick as volume is least. No point of it is farther from the hull
/// than twice its radius. (At every height between its ends, along its axis, the hull has a point within the
/// radius of the axis: each end is where a point of the hull asks for it, and that point is no nearer to the
/// other end.) The same points in the same order give the same capsule. Precondition: there is a point, and
/// all are finite.
model::Capsule enclosing_capsule(const std::vector<Eigen::Vector3d>& points);

/// The smallest such capsule whose axis has one of these directions (unit vectors, at least one).
model::Capsule enclosing_capsule(const std::vector<Eigen::Vector3d>& points,
                                 const std::vector<Eigen::Vector3d>& directions);

/// Capsules that together hold a solid, given by the corners of its surface's triangles, three after three:
/// one, or a few where these have a much smaller volume together. Each holds all of the solid between two
/// planes across its length, and keeps the bound above for that slice. Preconditions as above, and the
/// number of points is a multiple of three.
std::vector<model::Capsule> enclosing_capsules(const std::vector<Eigen::Vector3d>& triangles,
                                               std::size_t most = 3);

double volume(const model::Capsule&);

/// Does the one hold all of the other, but for rounding?
bool covers(const model::Capsule& outer, const model::Capsule& inner);

/// Without those that another one covers.
std::vector<model::Capsule> without_covered(const std::vector<model::Capsule>&);

}  // namespace limpet::kinematics
