// Copyright the limpet authors. GPL-3.0-or-later.
#include "promotion_internal.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <limpet/geometry/extend.hpp>
#include <limpet/geometry/predicates.hpp>

namespace limpet::model::internal {
namespace {

/// Could so few points lie this close to a plane by chance? If they were spread evenly over a slab as thick
/// as they are wide, each point would be within two standard deviations of the plane with probability q; any
/// three of them are. The bound 10⁻⁵ allows for the many point segments that are tried.
bool plane_by_chance(const Fit& fit, double variance) {
  const double q = std::sqrt(4 * variance / (3 * fit.u2));
  double probability = 1;
  for (double k = 3; k < fit.count && probability > 1e-5; ++k) probability *= q;
  return probability > 1e-5;
}

/// The fit without the `levers` points that determine the plane most: those farthest from its long axis. A
/// scan line and one or two outliers easily lie in a plane; the line alone determines none.
Fit without_levers(const Setting& setting, Fit fit, const std::vector<const std::vector<RawPoint>*>& raw,
                   int levers) {
  std::vector<GridPoint> points;
  for (const auto* some : raw)
    for (const RawPoint& r : *some) points.push_back(r.at);
  if (static_cast<double>(points.size()) != fit.count) return fit;  // some points are not kept any more
  for (; levers > 0 && points.size() > 3; --levers) {
    const auto across = [&](const GridPoint& p) {
      return std::abs(fit.axis2.dot(setting.world(p) - fit.centroid));
    };
    points.erase(std::max_element(points.begin(), points.end(), [&](const GridPoint& a, const GridPoint& b) {
      return across(a) < across(b);
    }));
    Moments moments;
    for (const GridPoint& p : points) moments.add(p);
    fit = fit_to(moments, setting.step, -fit.normal);  // the long axis turns when a point goes
  }
  return fit;
}

bool normal_known(const Setting& setting, const Fit& fit, double variance) {
  if (fit.u2 <= 4 * variance) return false;
  return std::sqrt(variance / (fit.count * (fit.u2 - variance))) < setting.parameters.angle_rad / 2;
}

/// The thesis's diamond: vertices at the standard deviations along the two large axes.
std::optional<geometry::Polygon> diamond(geometry::EdgeIds& edge_ids, const geometry::Chart& chart,
                                         const Fit& fit) {
  const Eigen::Vector3d a = std::sqrt(fit.u1) * fit.axis1, b = std::sqrt(fit.u2) * fit.axis2;
  const bool right_handed = a.cross(b).dot(chart.normal()) > 0;
  std::vector<geometry::NewVertex> cycle;
  for (const Eigen::Vector3d& p : {a, right_handed ? b : Eigen::Vector3d(-b), Eigen::Vector3d(-a),
                                   right_handed ? Eigen::Vector3d(-b) : b})
    cycle.push_back({geometry::round_to_grid(chart.project(fit.centroid + p))});
  const std::array cycles = {cycle};
  return geometry::Polygon::from_cycles(cycles, edge_ids);
}

}  // namespace

bool too_few_arrived(const Complex& complex, const Fit& fit, double since_sum) {
  const auto points = static_cast<double>(complex.now());
  const double waited = points - since_sum / fit.count;
  const double area =
      12 * std::sqrt(fit.u1 * fit.u2) /
      complex.setting().scale_at(fit.centroid).lambda2;  // of a rectangle with these variances
  const auto modelled = static_cast<double>(complex.modelled_points());
  return kArrivalShare * fit.count * complex.modelled_area() * points < waited * area * modelled;
}

bool points_came_too_slowly(const Complex& complex, const Segment& s) {
  const auto points = static_cast<double>(complex.now()), count = static_cast<double>(s.count());
  const double waited = points - s.data.sums().since / count;
  return kArrivalShare * count * complex.modelled_area() * points <
         waited * static_cast<double>(complex.modelled_points());
}

bool promotable(const Complex& complex, const Fit& fit, const SegmentData::Sums& sums,
                const std::vector<const std::vector<RawPoint>*>& raw) {
  const Setting& setting = complex.setting();
  const Rules& rules = setting.rules();
  if (!rules.promotion) {
    // Thesis §2.2: a polygon unless s_pt² < s_pp² or the points are collinear (two eigenvalues zero).
    return fit.count >= 3 && fit.u3 < setting.scale_at(fit.centroid).lambda2 && fit.u2 > 1e-9 * fit.u1 &&
           fit.u2 > 0 && faces_outside(fit.normal, sums.axis);
  }
  const double m = fit.count, v = sums.variance / fit.count;
  if (m < 5 || fit.u3 > 4 * v * (m - 3) / m || !normal_known(setting, fit, v)) return false;
  if (!faces_outside(fit.normal, sums.axis)) return false;
  const double cos_85 = 0.08715574274765817;
  if (-fit.normal.dot(sums.axis) < cos_85 * std::sqrt(sums.axis.dot(sums.axis))) return false;
  if (rules.arrival && too_few_arrived(complex, fit, sums.since)) return false;
  if (!rules.chance) return true;
  const Fit firm = without_levers(setting, fit, raw, 1);
  return normal_known(setting, firm, v) && !plane_by_chance(firm, v) &&
         without_levers(setting, fit, raw, 2).u2 > 4 * v;
}

std::unique_ptr<PolygonPart> diamond_part(Complex& complex, const Fit& fit) {
  auto part = std::make_unique<PolygonPart>();
  part->chart = geometry::Chart(fit.plane(), fit.axis1, complex.setting().step);
  auto perimeter = diamond(complex.edge_ids(), part->chart, fit);
  if (!perimeter) return nullptr;  // too small for the grid
  part->perimeter = std::move(*perimeter);
  part->published = geometry::Lift(part->chart, fit.plane());
  part->outward = fit.normal;
  part->initial = fit.plane();
  return part;
}

void promote(Complex& complex, const Segment& s, std::unique_ptr<PolygonPart> part) {
  // The diamond is extended to the points that are still kept, from the middle outwards.
  std::vector<std::pair<double, geometry::Point2>> points;
  for (const RawPoint& raw : s.data.raw()) {
    const geometry::Point2 q = geometry::round_to_grid(part->chart.project(complex.setting().world(raw.at)));
    points.emplace_back(geometry::squared_length(q), q);
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  const double gap = complex.setting().scale_at(s.fit.centroid).gap;
  for (const auto& [distance2, q] : points)
    geometry::extend_to_point(part->perimeter, q, gap, complex.edge_ids());
  part->perimeter.take_removed();  // none of these edges was on a segment yet
  complex.become_polygon(s, std::move(part));
}

}  // namespace limpet::model::internal
