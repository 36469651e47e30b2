// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

// A cloud as CGAL's plane detectors take it, whole and with normals. Included by the .cpp files that call
// them alone.

#include <string>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/property_map.h>

#include "plane_detector.hpp"

namespace limpet::benchmarks::internal {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Oriented = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using PointMap = CGAL::First_of_pair_property_map<Oriented>;
using NormalMap = CGAL::Second_of_pair_property_map<Oriented>;
using OrientedPoints = std::vector<Oriented>;
using Regions = std::vector<std::vector<std::size_t>>;  ///< indices of the points of each

/// With the true normals.
inline OrientedPoints read_oriented(const ScanCase& scan_case, const std::string& path) {
  OrientedPoints points;
  points.reserve(static_cast<std::size_t>(1.06 * static_cast<double>(scan_case.spec.points)));
  CloudReader reader(path);
  for (auto some = reader.next(4096); !some.empty(); some = reader.next(4096)) {
    for (const auto& p : some) {
      const Eigen::Vector3d n = p.face >= 0 ? scan_case.faces[static_cast<std::size_t>(p.face)].normal
                                            : Eigen::Vector3d(-p.point.axis);
      const Eigen::Vector3d& at = p.point.position;
      points.emplace_back(Kernel::Point_3(at.x(), at.y(), at.z()), Kernel::Vector_3(n.x(), n.y(), n.z()));
    }
  }
  return points;
}

/// estimate_normals.cpp: by the nearest points of each, not oriented, as neither detector asks for that.
void estimate_normals(OrientedPoints&);

/// answer_region_growing.cpp: planes by CGAL's region growing, neighbours by the nearest points.
Regions grow_regions(const ScanCase&, const OrientedPoints&);

}  // namespace limpet::benchmarks::internal
