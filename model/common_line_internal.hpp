// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <optional>

#include <limpet/geometry/chart.hpp>
#include <limpet/geometry/polygon.hpp>
#include <limpet/geometry/predicates.hpp>

#include "thresholds_internal.hpp"

namespace limpet::model::internal {

inline double sine_between(const geometry::Plane& a, const geometry::Plane& b) {
  const Eigen::Vector3d c = a.normal.cross(b.normal);
  return std::sqrt(c.dot(c));
}

/// The line where two planes meet, directed along n₁ × n₂. Where two segments meet convexly, this is the
/// anticlockwise direction of the edges on the first that are shared with the second (thesis §2.2).
struct CommonLine {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d along = Eigen::Vector3d::UnitX();  ///< unit
  double sine = 1;                                   ///< of the angle between the planes

  /// Coordinate along the line of the foot of p, from the origin, scan's unit.
  double place_of(const Eigen::Vector3d& p) const { return along.dot(p - origin); }
  Eigen::Vector3d at(double place) const { return origin + place * along; }
};

/// Nothing when the planes are parallel or nearly so (kLeastSine). The origin is the line's point nearest to
/// `near`.
inline std::optional<CommonLine> common_line(const geometry::Plane& a, const geometry::Plane& b,
                                             const Eigen::Vector3d& near) {
  CommonLine line;
  line.along = a.normal.cross(b.normal);
  line.sine = std::sqrt(line.along.dot(line.along));
  if (!(line.sine > kLeastSine)) return std::nullopt;
  line.along /= line.sine;
  const double cosine = a.normal.dot(b.normal), ha = a.height_of(near), hb = b.height_of(near);
  const double det = line.sine * line.sine;
  line.origin = near + (cosine * hb - ha) / det * a.normal + (cosine * ha - hb) / det * b.normal;
  return line;
}

/// The point where the line meets a third plane; nothing when the two are parallel or nearly so.
inline std::optional<Eigen::Vector3d> common_point(const CommonLine& line, const geometry::Plane& plane) {
  const double slope = plane.normal.dot(line.along);
  if (!(std::abs(slope) > kLeastSine)) return std::nullopt;
  return line.at(-plane.height_of(line.origin) / slope);
}

/// Do two shared edges of a perimeter, the second behind the first with nothing between them but what a
/// corner replaces, run on in one line or nearly so (kRunsOnSine)? Then their lines say too little of where
/// they meet.
inline bool run_on(const geometry::Polygon& perimeter, geometry::Slot before, geometry::Slot after,
                   const CommonLine& line_before, const CommonLine& line_after) {
  const geometry::Point2 from = perimeter.end(before) - perimeter.at(before),
                         to = perimeter.end(after) - perimeter.at(after);
  if (dot(from, to) <= 0) return false;  // the two sides of a spike
  const Eigen::Vector3d turn = line_before.along.cross(line_after.along);
  return turn.dot(turn) < kRunsOnSine * kRunsOnSine;
}

}  // namespace limpet::model::internal
