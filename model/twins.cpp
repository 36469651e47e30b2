// Copyright the limpet authors. GPL-3.0-or-later.
//
// Where a scan comes row by row, or is noisier than it is said to be, the first readings of a surface may lie
// in a wrong plane, which then takes the readings of its row from the true one. Neither's readings allow the
// other's plane any more.
#include "twins_internal.hpp"

#include <limpet/geometry/predicates.hpp>

namespace limpet::model::internal {
namespace {

/// Is the height of the centroid less than the spread of the heights about it that noise does not explain?
bool cross(const Segment& large, const Segment& small, double residual2) {
  const double height = large.fit.height_of(small.fit.centroid);
  return 2 * height * height + small.data.variance() <= residual2;
}

bool overlap(const PolygonPart& large, const PolygonPart& small) {
  std::size_t inside = 0;
  for_each_edge(small.perimeter, [&](geometry::Slot vertex) {
    const geometry::Point2 at = geometry::round_to_grid(large.chart.project(small.position(vertex)));
    inside += large.perimeter.locate(at) == geometry::Polygon::Side::inside;
  });
  return 2 * inside > small.perimeter.edge_count();
}

}  // namespace

bool are_twins(const Setting& setting, const Segment& large, const Segment& small, double residual2) {
  if (!setting.rules().twins || !large.mature_polygon() || !small.mature_polygon()) return false;
  if (large.fit.normal.dot(small.fit.normal) <= setting.cos_angle) return false;
  const double tolerance2 = setting.parameters.tolerance * setting.parameters.tolerance;
  return (residual2 <= tolerance2 / 4 || (residual2 <= tolerance2 && cross(large, small, residual2))) &&
         overlap(*large.polygon, *small.polygon);
}

}  // namespace limpet::model::internal
