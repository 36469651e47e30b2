// Copyright the limpet authors. GPL-3.0-or-later.
#include "segment_internal.hpp"

namespace limpet::model::internal {

Box3 box_around(const Eigen::Vector3d& p, double reach) {
  return {p - Eigen::Vector3d::Constant(reach), p + Eigen::Vector3d::Constant(reach)};
}

Box3 perimeter_box(const PolygonPart& part) {
  Box3 box;
  for_each_edge(part.perimeter, [&](geometry::Slot s) { box.extend(part.position(s)); });
  return box;
}

}  // namespace limpet::model::internal
