// Copyright the limpet authors. GPL-3.0-or-later.
#include "publish_internal.hpp"

#include <cmath>

#include <limpet/geometry/mend.hpp>
#include <limpet/geometry/predicates.hpp>

#include "sharing_internal.hpp"

namespace limpet::model::internal {
namespace {

std::vector<std::vector<geometry::NewVertex>> projected(const geometry::Chart& to,
                                                        const geometry::Chart& from,
                                                        const geometry::Lift& lift,
                                                        const geometry::Polygon& polygon) {
  auto cycles = polygon.boundary();
  for (auto& cycle : cycles)
    for (auto& v : cycle) v.at = geometry::round_to_grid(to.project(from.at(v.at, lift(v.at))));
  return cycles;
}

std::optional<geometry::Polygon> polygon_in(Complex& complex, const geometry::Chart& to,
                                            const geometry::Chart& from, const geometry::Lift& lift,
                                            const geometry::Polygon& polygon) {
  const double gap = complex.setting().scale_at(from.origin()).gap;
  auto cycles = projected(to, from, lift, polygon);
  if (auto result = geometry::Polygon::from_cycles(cycles, complex.edge_ids())) return result;
  if (geometry::restore_sides(cycles, polygon.boundary()))
    if (auto result = geometry::Polygon::from_cycles(cycles, complex.edge_ids())) return result;
  // What rounding has made invalid is mended, as long as that changes an area of less than (λ/4)².
  if (!geometry::mend_cycles(cycles, gap * gap / 16)) return std::nullopt;
  return geometry::Polygon::from_cycles(cycles, complex.edge_ids());
}

/// Largest distance between two lifts over a box, in grid steps. Lifts are affine, so it is at a corner.
double largest_shift(const geometry::Lift& a, const geometry::Lift& b, const geometry::Box2& box) {
  double shift = 0;
  for (const geometry::Point2 p :
       {box.low, box.high, geometry::Point2{box.low.x, box.high.y}, geometry::Point2{box.high.x, box.low.y}})
    shift = std::max(shift, std::abs(a(p) - b(p)));
  return shift;
}

bool rechart(Complex& complex, const Segment& s) {
  const PolygonPart& part = *s.polygon;
  const geometry::Plane plane = s.fit.plane();
  const geometry::Chart chart(plane, part.chart.u(), complex.setting().step);
  const geometry::Lift lift(part.chart, plane);
  auto perimeter = polygon_in(complex, chart, part.chart, lift, part.perimeter);
  if (!perimeter) return false;
  complex.replace_perimeter(s, chart, std::move(*perimeter), plane);
  return true;
}

void publish(Complex& complex, const Agenda& agenda, const Segment& s) {
  const Setting& setting = complex.setting();
  const PolygonPart& part = *s.polygon;
  const geometry::Lift lift(part.chart, s.fit.plane());
  // A shift d of the plane moves an intersection line by up to d / sin μ. When finishing, every plane that
  // has moved by more than a step is published.
  const double shift = largest_shift(lift, part.published, part.perimeter.box());
  complex.set_stale(s, false);
  if (shift <=
      (agenda.finishing ? 1 : setting.scale_at(s.fit.centroid).gap / kPublishPart * setting.sin_angle))
    return;
  complex.set_stale(s, s.count() > 0 && !faces_outside(s.fit.normal, s.data.axis_sum()));
  if (part.stale) return;
  complex.with_ends_apart([&] {
    if (!(lift.squared_tilt() > kRechartTilt2 && rechart(complex, s))) {
      complex.set_stale(s, lift.squared_tilt() > kMaxTilt2);
      if (part.stale) return;
      complex.set_plane(s, lift, s.fit.normal);
    }
    reposition(complex, s, part.shared);
  });
  if (!part.stale) complex.plane_moved(s);
}

}  // namespace

bool differs_from_initial(const Setting& setting, const PolygonPart& part, const Fit& fit) {
  return part.initial.normal.dot(fit.normal) < setting.cos_angle ||
         std::abs(part.initial.height_of(fit.centroid)) > setting.scale_at(fit.centroid).lambda;
}

void refit(Complex& complex, const Agenda& agenda, const Segment& s) {
  if (s.initial()) return;
  const Setting& setting = complex.setting();
  complex.set_fit(s, fit_to(s.data.moments(), setting.step, -s.fit.normal),
                  s.count() + 1 + s.count() / kGrowthPart);
  if (!s.polygon) return;
  const PolygonPart& part = *s.polygon;
  if (setting.rules().refresh && s.fit.normal_error(s.data.variance()) < setting.parameters.angle_rad / 20 &&
      (part.initial.normal - s.fit.normal).norm() < setting.parameters.angle_rad)
    complex.set_initial_plane(s, s.fit.plane());
  publish(complex, agenda, s);
}

bool variance_allowed(const Setting& setting, const PolygonPart& part, const Moments& merged) {
  // The margin makes it true in exact arithmetic, too.
  return merged.squared_residual(part.published.plane(part.chart), setting.step) <
         0.999 * setting.scale_at(merged.centroid(setting.step)).lambda2;
}

std::optional<geometry::Polygon> in_chart(Complex& complex, const geometry::Chart& chart,
                                          const PolygonPart& b) {
  return polygon_in(complex, chart, b.chart, b.published, b.perimeter);
}

}  // namespace limpet::model::internal
