// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/model/view.hpp>
#include <vector>

namespace limpet::drawing {

/// A flat part of something round: three or four corners, anticlockwise as seen from outside.
struct Facet {
  std::vector<Eigen::Vector3d> corners;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< outwards, unit vector
};

/// The surface of a capsule in facets, all corners on it: closed, convex, and within 2 % of the radius.
/// Precondition: finite, and the radius is positive.
std::vector<Facet> facets_of(const model::Capsule&);

}  // namespace limpet::drawing
