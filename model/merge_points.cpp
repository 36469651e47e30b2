// Copyright the limpet authors. GPL-3.0-or-later.
//
// Merging two point segments (thesis §2.4.1), and when the result is a planar polygon segment (DESIGN:
// promotion).
#include <algorithm>
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

/// Is the normal known well enough to be a polygon's?
bool promotable(const Engine& e, const Fit& fit, const Eigen::Vector3d& axis_sum) {
  const double lambda2 = e.parameters.resolution * e.parameters.resolution;
  if (!e.rules().promotion) {
    // Thesis §2.2: a polygon unless s_pt² < s_pp² or the points are collinear (two eigenvalues zero).
    return fit.count >= 3 && fit.u3 < lambda2 && fit.u2 > 1e-9 * fit.u1 && fit.u2 > 0;
  }
  const double m = fit.count, v = e.variance;
  if (m < 5 || fit.u2 <= 4 * v || fit.u3 > 4 * v * (m - 3) / m) return false;
  const double error = std::sqrt(v / (m * (fit.u2 - v)));
  if (error >= e.parameters.angle_rad / 2) return false;
  if (e.rules().chance && plane_by_chance(fit, v)) return false;
  const double cos_80 = 0.17364817766693033;
  return -fit.normal.dot(axis_sum) >= cos_80 * std::sqrt(axis_sum.dot(axis_sum));
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

std::unique_ptr<PolygonPart> diamond_part(Engine& e, const Fit& fit) {
  auto part = std::make_unique<PolygonPart>();
  part->chart = geometry::Chart(fit.plane(), fit.axis1, e.step);
  auto perimeter = diamond(e, part->chart, fit);
  if (!perimeter) return nullptr;  // too small for the grid
  part->perimeter = std::move(*perimeter);
  part->published = geometry::Lift(part->chart, fit.plane());
  part->initial = fit.plane();
  return part;
}

void promote(Engine& e, Segment& s, std::unique_ptr<PolygonPart> new_part) {
  s.polygon = std::move(new_part);
  PolygonPart& part = *s.polygon;
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

/// Points of point segments around a new polygon may fit it now: each tries again on its own.
void release_neighbours(Engine& e, const Segment& polygon) {
  e.index.query(polygon.indexed, e.found);
  std::vector<std::pair<SegmentId, std::uint32_t>> near;
  for (const std::uint32_t slot : e.found) {
    Segment& s = e.at(slot);
    if (!s.polygon && s.young() && polygon.indexed.contains(s.fit.centroid)) near.emplace_back(s.id, slot);
  }
  std::sort(near.begin(), near.end());
  for (const auto& [id, slot] : near) release_points(e, e.at(slot), false);
}

}  // namespace

PointMerger merge_point_segments(Engine& e, Segment& into, Segment& from) {
  if (into.axis_sum.dot(from.axis_sum) < 0) return PointMerger::refused;  // opposing sensing axes
  Moments moments = into.moments;
  moments.add(from.moments);
  const Eigen::Vector3d axis_sum = into.axis_sum + from.axis_sum;
  const Fit fit = fit_to(moments, e.step, axis_sum);
  const double lambda2 = e.parameters.resolution * e.parameters.resolution;
  const bool small = fit.point_variance() < lambda2;
  auto part = promotable(e, fit, axis_sum) && fit.u3 < lambda2 ? diamond_part(e, fit) : nullptr;
  if (!part && !small) return PointMerger::refused;

  const bool young = into.young() && from.young() && moments.count() <= kYoung;
  into.moments = moments;
  into.axis_sum = axis_sum;
  into.fit = fit;
  if (young)
    into.raw.insert(into.raw.end(), from.raw.begin(), from.raw.end());
  else
    into.raw.clear();
  into.last_joined = e.counts.points;
  e.by_age.emplace_back(into.last_joined, into.id);
  forward_label(e, from.id, into.id);
  e.changes.push_back({Change::Kind::merged, into.id, from.id, into.id, {}});
  erase_segment(e, from);
  mark_modified(e, into);
  if (part) {
    promote(e, into, std::move(part));
    if (e.rules().dissolve) release_neighbours(e, into);
    return PointMerger::polygon;
  }
  update_index(e, into);
  return PointMerger::point;
}

}  // namespace limpet::model::internal
