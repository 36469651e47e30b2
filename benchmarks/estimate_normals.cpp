// Copyright the limpet authors. GPL-3.0-or-later.
#include <CGAL/pca_estimate_normals.h>

#include "cgal_cloud_internal.hpp"

namespace limpet::benchmarks::internal {

void estimate_normals(OrientedPoints& points) {
  CGAL::pca_estimate_normals<CGAL::Sequential_tag>(
      points, kNeighbours, CGAL::parameters::point_map(PointMap()).normal_map(NormalMap()));
}

}  // namespace limpet::benchmarks::internal
