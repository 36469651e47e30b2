// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/evaluation/nearest.hpp>
#include <limpet/evaluation/planar_face.hpp>
#include <utility>
#include <vector>

namespace limpet::evaluation {

/// A planar polygon made ready for being measured.
struct Region {
  explicit Region(const PlanarFace& face);

  PlanarFace face;
  std::vector<Triangle3> triangles;
  NearestSurface surface;  ///< distance to the polygon's area, holes left out
  double area = 0;
  Eigen::Vector3d low, high;  ///< bounding box of the vertices

  /// The point's foot on the polygon's plane.
  Eigen::Vector3d foot(const Eigen::Vector3d& point) const;
};

std::vector<Region> regions(const std::vector<PlanarFace>& faces);

/// Points spread evenly over the area of triangles, `count` in all (none if there is no area): a
/// low-discrepancy sequence, the same every time.
std::vector<Eigen::Vector3d> spread_over(const std::vector<Triangle3>& triangles, int count);

/// Points along all boundary cycles, every vertex among them, none farther than `spacing` from the next.
std::vector<Eigen::Vector3d> along_boundary(const PlanarFace& face, double spacing);

/// The edges of all boundary cycles.
std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> boundary_segments(const PlanarFace& face);

/// Which of `candidates` each polygon lies on: faces the same way within `max_angle_rad`, and has the largest
/// share of its area within `reach`, near parts weighing more; −1 if less than half of its area lies on
/// candidates at all, or it has no area.
std::vector<int> matches(const std::vector<Region>& polygons, const std::vector<Region>& candidates,
                         double reach, double max_angle_rad);

/// The share of a polygon's area that lies within `reach` of candidates that face the same way.
double covered_share(const Region& polygon, const std::vector<Region>& candidates, double reach,
                     double max_angle_rad);

/// Angle between two unit vectors, accurate for small ones.
double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

}  // namespace limpet::evaluation
