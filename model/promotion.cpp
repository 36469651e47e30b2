// Copyright the limpet authors. GPL-3.0-or-later.
//
// When is a segment a polygon? The rule that makes a point segment a planar polygon segment, and its first
// perimeter.
#include <algorithm>
#include <array>
#include <cmath>

#include <limpet/geometry/extend.hpp>
#include <limpet/geometry/predicates.hpp>

#include "engine_internal.hpp"

namespace limpet::model::internal {
namespace {

/// Could so few points lie this close to a plane by chance? Were they spread evenly over a slab as thick as
/// they are wide, a point would come within two standard deviations of the plane with probability q; three of
/// them always do. The bound 10⁻⁵ is small against the number of point segments that are ever tried.
bool plane_by_chance(const Fit& fit, double variance) {
  const double q = std::sqrt(4 * variance / (3 * fit.u2));
  double probability = 1;
  for (double k = 3; k < fit.count && probability > 1e-5; ++k) probability *= q;
  return probability > 1e-5;
}

/// The fit without the `levers` points that most determine the plane: those farthest off the long axis. A
/// scan line and one or two outliers lie in a plane only too easily; without the outliers they are no plane
/// at all.
Fit without_levers(const Engine& e, Fit fit, const std::vector<const std::vector<RawPoint>*>& raw,
                   int levers) {
  std::vector<GridPoint> points;
  for (const auto* some : raw)
    for (const RawPoint& r : *some) points.push_back(r.at);
  if (static_cast<double>(points.size()) != fit.count) return fit;  // not all are kept any more
  for (; levers > 0 && points.size() > 3; --levers) {
    const auto across = [&](const GridPoint& p) {
      return std::abs(fit.axis2.dot(e.world(p) - fit.centroid));
    };
    points.erase(std::max_element(points.begin(), points.end(), [&](const GridPoint& a, const GridPoint& b) {
      return across(a) < across(b);
    }));
    Moments moments;
    for (const GridPoint& p : points) moments.add(p);
    fit = fit_to(moments, e.step, -fit.normal);  // the long axis turns when its lever goes
  }
  return fit;
}

bool normal_known(const Engine& e, const Fit& fit, double variance) {
  if (fit.u2 <= 4 * variance) return false;
  return std::sqrt(variance / (fit.count * (fit.u2 - variance))) < e.parameters.angle_rad / 2;
}

/// The thesis's diamond: vertices at the standard deviations along the two large axes.
std::optional<geometry::Polygon> diamond(Engine& e, const geometry::Chart& chart, const Fit& fit) {
  const Eigen::Vector3d a = std::sqrt(fit.u1) * fit.axis1, b = std::sqrt(fit.u2) * fit.axis2;
  const bool right_handed = a.cross(b).dot(chart.normal()) > 0;
  std::vector<geometry::NewVertex> cycle;
  for (const Eigen::Vector3d& p : {a, right_handed ? b : Eigen::Vector3d(-b), Eigen::Vector3d(-a),
                                   right_handed ? Eigen::Vector3d(-b) : b})
    cycle.push_back({geometry::round_to_grid(chart.project(fit.centroid + p))});
  const std::array cycles = {cycle};
  return geometry::Polygon::from_cycles(cycles, e.edge_ids);
}

}  // namespace

/// Had this been a surface all the time that its points have been waiting, about as many points would have
/// come to each λ² of it as to any λ² of the surface that is known. Where a stream is long, outliers, and
/// readings far out in the tails of the noise, make planes, too, but they take their time: below a thirtieth
/// it is no surface.
bool too_few_arrived(const Engine& e, const Fit& fit, double since_sum) {
  const double lambda2 = e.parameters.resolution * e.parameters.resolution;
  const auto points = static_cast<double>(e.counts.points);
  const double waited = points - since_sum / fit.count;
  const double area = 12 * std::sqrt(fit.u1 * fit.u2) / lambda2;  // of a rectangle with these variances
  const auto modelled = static_cast<double>(e.modelled_points);
  return 30 * fit.count * e.modelled_area * points < waited * area * modelled;
}

bool points_came_too_slowly(const Engine& e, const Segment& s) {
  const auto points = static_cast<double>(e.counts.points), count = static_cast<double>(s.moments.count());
  const double waited = points - s.since_sum / count;
  return 30 * count * e.modelled_area * points < waited * static_cast<double>(e.modelled_points);
}

bool promotable(const Engine& e, const Fit& fit, double v, const Eigen::Vector3d& axis_sum,
                const std::vector<const std::vector<RawPoint>*>& raw, double since_sum) {
  const double lambda2 = e.parameters.resolution * e.parameters.resolution;
  if (!e.rules().promotion) {
    // Thesis §2.2: a polygon unless s_pt² < s_pp² or the points are collinear (two eigenvalues zero).
    return fit.count >= 3 && fit.u3 < lambda2 && fit.u2 > 1e-9 * fit.u1 && fit.u2 > 0 &&
           faces_outside(fit.normal, axis_sum);
  }
  const double m = fit.count;
  if (m < 5 || fit.u3 > 4 * v * (m - 3) / m || !normal_known(e, fit, v)) return false;
  if (!faces_outside(fit.normal, axis_sum)) return false;
  const double cos_80 = 0.17364817766693033;
  if (-fit.normal.dot(axis_sum) < cos_80 * std::sqrt(axis_sum.dot(axis_sum))) return false;
  if (e.rules().arrival && too_few_arrived(e, fit, since_sum)) return false;
  if (!e.rules().chance) return true;
  const Fit firm = without_levers(e, fit, raw, 1);
  return normal_known(e, firm, v) && !plane_by_chance(firm, v) && without_levers(e, fit, raw, 2).u2 > 4 * v;
}

std::unique_ptr<PolygonPart> diamond_part(Engine& e, const Fit& fit) {
  auto part = std::make_unique<PolygonPart>();
  part->chart = geometry::Chart(fit.plane(), fit.axis1, e.step);
  auto perimeter = diamond(e, part->chart, fit);
  if (!perimeter) return nullptr;  // too small for the grid
  part->perimeter = std::move(*perimeter);
  part->published = geometry::Lift(part->chart, fit.plane());
  part->outward = fit.normal;
  part->initial = fit.plane();
  return part;
}

void promote(Engine& e, Segment& s, std::unique_ptr<PolygonPart> new_part) {
  s.polygon = std::move(new_part);
  e.modelled_points += s.moments.count();
  PolygonPart& part = *s.polygon;
  if (!s.young()) add_to_relief(e, part, s.fit.centroid, static_cast<double>(s.moments.count()));
  // The points are still there: the diamond is extended to them, from the middle outwards.
  std::vector<std::pair<double, geometry::Point2>> points;
  for (const RawPoint& raw : s.raw) {
    const geometry::Point2 q = geometry::round_to_grid(part.chart.project(e.world(raw.at)));
    points.emplace_back(geometry::squared_length(q), q);
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [distance2, q] : points) geometry::extend_to_point(part.perimeter, q, e.gap, e.edge_ids);
  part.perimeter.take_removed();
  for (const auto& created : part.perimeter.take_created()) part.fresh.push_back(created);
  part.box = perimeter_box(part);
  s.next_fit = s.moments.count() + 1;
  update_index(e, s);
  description_changed(e, s, part.box);
  e.changes.push_back({Change::Kind::became_polygon, {}, {}, s.id, {}});
}

}  // namespace limpet::model::internal
