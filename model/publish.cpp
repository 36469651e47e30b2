// Copyright the limpet authors. GPL-3.0-or-later.
//
// The plane of best fit moves with every point; the published plane, on which perimeters lie, only when it
// matters.
#include <cmath>

#include <limpet/geometry/mend.hpp>
#include <limpet/geometry/predicates.hpp>

#include "engine_internal.hpp"

namespace limpet::model::internal {
namespace {

/// tan² of the tilt between plane and chart beyond which the polygon gets a new chart (1°), and beyond which
/// a plane is not published on a chart at all (2.5°).
constexpr double kRechartTilt2 = 3.047e-4, kMaxTilt2 = 1.906e-3;

std::vector<std::vector<geometry::NewVertex>> projected(const geometry::Chart& to,
                                                        const geometry::Chart& from,
                                                        const geometry::Lift& lift,
                                                        const geometry::Polygon& polygon) {
  auto cycles = polygon.boundary();
  for (auto& cycle : cycles)
    for (auto& v : cycle) v.at = geometry::round_to_grid(to.project(from.at(v.at, lift(v.at))));
  return cycles;
}

std::optional<geometry::Polygon> polygon_in(Engine& e, const geometry::Chart& to, const geometry::Chart& from,
                                            const geometry::Lift& lift, const geometry::Polygon& polygon) {
  auto cycles = projected(to, from, lift, polygon);
  if (auto result = geometry::Polygon::from_cycles(cycles, e.edge_ids)) return result;
  if (geometry::restore_sides(cycles, polygon.boundary()))
    if (auto result = geometry::Polygon::from_cycles(cycles, e.edge_ids)) return result;
  // What rounding broke is mended, as long as that changes less than (λ/4)².
  if (!geometry::mend_cycles(cycles, e.gap * e.gap / 16)) return std::nullopt;
  return geometry::Polygon::from_cycles(cycles, e.edge_ids);
}

/// Largest distance between two lifts over a box, in grid steps: they are affine, so it is at a corner.
double largest_shift(const geometry::Lift& a, const geometry::Lift& b, const geometry::Box2& box) {
  double shift = 0;
  for (const geometry::Point2 p :
       {box.low, box.high, geometry::Point2{box.low.x, box.high.y}, geometry::Point2{box.high.x, box.low.y}})
    shift = std::max(shift, std::abs(a(p) - b(p)));
  return shift;
}

bool rechart(Engine& e, Segment& s) {
  PolygonPart& part = *s.polygon;
  const geometry::Plane plane = s.fit.plane();
  geometry::Chart chart(plane, part.chart.u(), e.step);
  const geometry::Lift lift(part.chart, plane);
  auto perimeter = polygon_in(e, chart, part.chart, lift, part.perimeter);
  if (!perimeter) return false;
  std::swap(part.chart, chart);
  rechart_relief(e, part, chart);
  part.perimeter = std::move(*perimeter);
  part.published = geometry::Lift(part.chart, plane);
  part.outward = plane.normal;
  perimeter_made_anew(e, s);  // slots are new: what was fresh is looked at again, all of it
  return true;
}

}  // namespace

bool differs_from_initial(const Engine& e, const PolygonPart& part, const Fit& fit) {
  return part.initial.normal.dot(fit.normal) < e.cos_angle ||
         std::abs(part.initial.height_of(fit.centroid)) > e.parameters.resolution;
}

void refit(Engine& e, Segment& s) {
  if (s.initial()) return;
  s.fit = fit_to(s.moments, e.step, -s.fit.normal);
  s.next_fit = s.moments.count() + 1 + s.moments.count() / 32;
  if (!s.polygon) return;
  PolygonPart& part = *s.polygon;
  if (e.rules().refresh && s.fit.normal_error(s.variance()) < e.parameters.angle_rad / 20 &&
      (part.initial.normal - s.fit.normal).norm() < e.parameters.angle_rad)
    part.initial = s.fit.plane();
  publish(e, s);
}

void refit_if_due(Engine& e, Segment& s) {
  if (s.young() || s.moments.count() >= s.next_fit) refit(e, s);
}

bool variance_allowed(const Engine& e, const PolygonPart& part, const Moments& merged) {
  // A margin, so that it holds exactly, too.
  const double lambda2 = e.parameters.resolution * e.parameters.resolution;
  return merged.squared_residual(part.published.plane(part.chart), e.step) < 0.999 * lambda2;
}

void publish(Engine& e, Segment& s) {
  PolygonPart& part = *s.polygon;
  const geometry::Lift lift(part.chart, s.fit.plane());
  // A shift d of the plane moves an intersection line by up to d / sin μ. In the end every plane is the best.
  const double shift = largest_shift(lift, part.published, part.perimeter.box());
  part.stale = false;
  if (shift <= (e.finishing ? 1 : e.gap / 16 * e.sin_angle)) return;
  part.stale = s.moments.count() > 0 && !faces_outside(s.fit.normal, s.axis_sum);
  if (part.stale) return;
  with_ends_apart(e, [&] {
    if (!(lift.squared_tilt() > kRechartTilt2 && rechart(e, s))) {
      part.stale = lift.squared_tilt() > kMaxTilt2;
      if (part.stale) return;
      part.published = lift, part.outward = s.fit.normal;
    }
    reposition(e, s, part.shared);
  });
  if (part.stale) return;
  part.box = perimeter_box(part);
  description_changed(e, s, part.box);
  update_index(e, s);
}

std::optional<geometry::Polygon> in_chart_of(Engine& e, const geometry::Chart& chart, const PolygonPart& b) {
  return polygon_in(e, chart, b.chart, b.published, b.perimeter);
}

}  // namespace limpet::model::internal
