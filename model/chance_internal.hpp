// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "complex_internal.hpp"

/// What chance alone leaves empty (docs/evidence.md). Chance is a property of discs, not of outlines.
namespace limpet::model::internal {

/// An area that a polygon is to be extended by, in a frame of its plane, scan's unit.
struct Addition {
  /// A side that becomes the polygon's own: no reading is expected beyond.
  struct Limit {
    Eigen::Vector2d through, inwards;  ///< `inwards`: a unit vector
  };
  Eigen::Vector3d origin, x, y;  ///< of the frame, in the world
  std::vector<Eigen::Vector2d> outline;
  std::vector<Limit> limits;
};

/// An addition of this outline, in the frame of the polygon's chart; and the side of it from one chart point
/// to another, with the polygon on its left.
Addition addition_on(const PolygonPart&, std::span<const geometry::Point2> outline);
Addition::Limit limit_along(const PolygonPart&, geometry::Point2 from, geometry::Point2 to);

/// The number of readings that are expected in an empty disc so large that chance leaves less than a
/// hundredth of one in a stream of m: 2m(1 + a)e^(−a) = kDiscsByChance. The judge of evaluation/ works it out
/// by itself.
double most_expected_in_empty_disc(std::int64_t m);

/// May the area be part of the surface although there is no reading in it? It may when all of it is within λ
/// of where the polygon was felt, or else, around each of its places, in the largest disc that was not felt,
/// there are no more readings expected than chance may leave out. At the density at which it was felt.
bool chance_explains(const Complex&, const Segment&, const Addition&);

}  // namespace limpet::model::internal
