// Copyright the limpet authors. GPL-3.0-or-later.
//
// The point of a segment nearest to a given point. On a polygon it is the foot of the perpendicular on its
// plane, if that is inside the perimeter; else the point of the perimeter, on the plane, that is nearest to
// the foot.
#include "lifted_internal.hpp"
#include "nearest_internal.hpp"

namespace limpet::model::internal {
namespace {

using geometry::Point2;
using geometry::Slot;

struct OnEdge {
  Point2 at;
  double squared = 0;  ///< squared distance on the plane, in grid steps
  geometry::EdgeId edge;
};

/// The point of the edge nearest to the foot, measured on the plane.
OnEdge nearest_on_edge(const Lifted& polygon, Slot s, Point2 foot) {
  const geometry::Polygon& perimeter = polygon.perimeter();
  const Point2 a = perimeter.at(s), b = perimeter.end(s);
  const double t = std::clamp(polygon.product(foot - a, b - a) / polygon.product(b - a, b - a), 0.0, 1.0);
  const Point2 at = a + t * (b - a), off = at - foot;
  return {at, polygon.product(off, off), perimeter.node(s).edge};
}

/// The point of the perimeter nearest to the foot; may be nothing if it is farther than `within`. Lengths in
/// grid steps.
std::optional<OnEdge> nearest_on_perimeter(const Lifted& polygon, Point2 foot, double within, double slack) {
  std::optional<OnEdge> best;
  const geometry::Polygon& perimeter = polygon.perimeter();
  look_at_edges_near(perimeter, {foot, foot}, within, slack, [&](Slot s) {
    if (best && best->edge == perimeter.node(s).edge) return within;  // it comes from several cells
    const double spare = within + slack;
    if (box_of(perimeter.at(s), perimeter.end(s)).squared_distance(foot) > spare * spare) return within;
    const OnEdge found = nearest_on_edge(polygon, s, foot);
    if (!best || found.squared < best->squared ||
        (found.squared == best->squared && found.edge < best->edge)) {
      best = found;
      within = std::min(within, std::sqrt(found.squared));
    }
    return within;
  });
  return best;
}

/// The nearest point of a polygon, which may still be beyond the limit.
std::optional<View::Nearest> nearest_on(const PolygonPart& part, const Eigen::Vector3d& p, double limit,
                                        double rounding) {
  const Lifted polygon(part);
  const double step = part.chart.step(), slack = rounding / step;
  const Eigen::Vector3d place = polygon.place(p);
  const double rise = polygon.rise(place), height = polygon.height(rise);
  if (std::abs(height) > limit / step + slack) return std::nullopt;
  const Point2 foot = polygon.foot(place, rise);
  View::Nearest result;
  if (polygon.inside(foot)) {
    result.at = polygon.world(foot);
    return result;
  }
  const auto found = nearest_on_perimeter(polygon, foot, reach_on_plane(limit / step, height, slack), slack);
  if (!found) return std::nullopt;
  result.at = polygon.world(found->at);
  result.edge = found->edge;
  return result;
}

}  // namespace

std::optional<View::Nearest> nearest_of(const Segment& s, const Eigen::Vector3d& p, double limit,
                                        double rounding) {
  std::optional<View::Nearest> result;
  if (s.polygon)
    result = nearest_on(*s.polygon, p, limit, rounding);
  else
    result.emplace().at = s.fit.centroid;
  if (!result) return result;
  result->segment = s.id;
  result->distance = length(result->at - p);
  if (result->distance > limit) result.reset();
  return result;
}

}  // namespace limpet::model::internal
