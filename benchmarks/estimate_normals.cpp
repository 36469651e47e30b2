// Copyright the limpet authors. GPL-3.0-or-later.
#include "estimate_normals.hpp"

#include <CGAL/pca_estimate_normals.h>

namespace limpet::benchmarks {

void estimate_normals(OrientedPoints& points) {
  CGAL::pca_estimate_normals<CGAL::Sequential_tag>(
      points, kNeighbours, CGAL::parameters::point_map(PointMap()).normal_map(NormalMap()));
}

}  // namespace limpet::benchmarks
