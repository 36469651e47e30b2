// Copyright the limpet authors. GPL-3.0-or-later.
//
// Merging a point segment and a planar polygon segment (thesis §2.4.2).
#include <algorithm>
#include <cmath>

#include <limpet/geometry/extend.hpp>
#include <limpet/geometry/predicates.hpp>
#include <limpet/geometry/search.hpp>

#include "engine_internal.hpp"

namespace limpet::model::internal {
namespace {

/// residual_limit() by noise alone.
double noise_limit(const Segment& polygon, const Eigen::Vector3d& p, double variance) {
  return 9 * (variance + polygon.fit.height_variance(p, polygon.variance()));
}

}  // namespace

double residual_limit(const Engine& e, const Segment& polygon, const Eigen::Vector3d& p, double variance) {
  const double by_noise = noise_limit(polygon, p, variance);
  // A young polygon's plane is not known well enough to tell what lies off it.
  if (e.rules().relief && polygon.young()) return by_noise;
  return std::max(by_noise, e.parameters.tolerance * e.parameters.tolerance);
}

Standing standing(const Engine& e, const Segment& s, const Eigen::Vector3d& p, const Eigen::Vector3d& axis,
                  double squared_residual, double variance) {
  Standing result;
  const double lambda2 = e.parameters.resolution * e.parameters.resolution;
  const double height = s.fit.height_of(p);
  if (height * height >= lambda2 || axis.dot(s.fit.normal) > 0) return result;
  if (e.rules().residual && squared_residual > residual_limit(e, s, p, variance)) return result;
  const PolygonPart& part = *s.polygon;
  result.chart_point = geometry::round_to_grid(part.chart.project(p));
  result.outside = part.perimeter.locate(result.chart_point) == geometry::Polygon::Side::outside;
  result.distance2 = height * height;
  if (relief_kept(e) && s.mature_polygon() && squared_residual > noise_limit(s, p, variance)) {
    const auto local = local_residual(e, s, p);
    if (!local || local->height * local->height > 9 * (variance + local->variance) + local->bend2)
      return result;
  }
  if (result.outside) {
    const auto nearest = geometry::nearest_perimeter_point(part.perimeter, result.chart_point, e.gap);
    if (!nearest) return result;
    result.perimeter_distance = std::sqrt(nearest->squared_distance);
    result.distance2 += nearest->squared_distance * e.step * e.step;
  }
  result.near = result.distance2 < lambda2;
  return result;
}

namespace {

/// The rules that look at the merged moments: the thesis's variance, and the initial plane while the polygon
/// is young (later the fit moves too little between two refits to drift unseen).
template <class Data>  // Moments, or a single GridPoint
bool merged_fit_accepted(const Engine& e, const Segment& polygon, const Data& added,
                         const Eigen::Vector3d& axis) {
  if (!faces_outside(polygon.polygon->outward, polygon.axis_sum + axis)) return false;
  const bool check_variance = !e.rules().residual;
  if (!check_variance && !polygon.young() && !polygon.polygon->stale) return true;
  Moments merged = polygon.moments;
  merged.add(added);
  if (!variance_allowed(e, *polygon.polygon, merged)) return false;
  if (!check_variance && !polygon.young()) return true;
  const Fit fit = fit_to(merged, e.step, -polygon.fit.normal);
  if (check_variance && fit.u3 >= e.parameters.resolution * e.parameters.resolution) return false;
  return !differs_from_initial(e, *polygon.polygon, fit);
}

/// The projected point becomes a vertex unless it is inside, or so near that it adds nothing.
bool extend_perimeter(Engine& e, Segment& polygon, const Standing& st) {
  if (!st.outside || (e.rules().near && st.perimeter_distance < e.gap / 4)) return true;
  PolygonPart& part = *polygon.polygon;
  const auto extension = geometry::extend_to_point(part.perimeter, st.chart_point, e.gap, e.edge_ids);
  if (extension == geometry::Extension::refused) return false;
  if (extension != geometry::Extension::extended) return true;
  if (auto removed = part.perimeter.take_removed(); !removed.empty())
    e.changes.push_back({Change::Kind::edges_removed, {}, {}, polygon.id, std::move(removed)});
  Box3 where;
  for (const auto& [slot, edge] : part.perimeter.take_created()) {
    part.fresh.emplace_back(slot, edge);
    const geometry::Point2 v = part.perimeter.at(slot);
    where.extend(part.chart.at(v, part.published(v)));
  }
  part.box.extend(where);
  description_changed(e, polygon, where);
  update_index(e, polygon);
  return true;
}

/// A polygon with so many points keeps them no longer one by one.
void mature(Engine& e, Segment& polygon) {
  for (const RawPoint& raw : polygon.raw) add_to_relief(e, *polygon.polygon, e.world(raw.at), 1);
  polygon.raw = std::vector<RawPoint>();  // `= {}` would keep the memory
  if (e.parameters.neighbours) polygon.polygon->unshared.add(polygon.polygon->box);
}

void joined(Engine& e, Segment& polygon) {
  polygon.last_joined = e.counts.points;
  mark_modified(e, polygon);
  refit_if_due(e, polygon);
}

}  // namespace

bool merge_point_into_polygon(Engine& e, Segment& polygon, const RawPoint& raw, const Standing& st) {
  if (!merged_fit_accepted(e, polygon, raw.at, raw.axis) || !extend_perimeter(e, polygon, st)) return false;
  const bool young = polygon.young();
  polygon.moments.add(raw.at);
  ++e.modelled_points;
  polygon.axis_sum += raw.axis;
  polygon.variance_sum += raw.variance;
  if (young) {
    polygon.raw.push_back(raw);
    if (raw.since < 0) polygon.raw.back().since = e.counts.points;
    polygon.since_sum += static_cast<double>(polygon.raw.back().since);
    if (!may_be_young(e, polygon.moments.count(), polygon.fit)) mature(e, polygon);
  } else {
    add_to_relief(e, *polygon.polygon, e.world(raw.at), 1);
  }
  set_label(e, raw, polygon.id);
  joined(e, polygon);
  return true;
}

bool merge_segment_into_polygon(Engine& e, Segment& polygon, Segment& point, const Standing& st) {
  if (!merged_fit_accepted(e, polygon, point.moments, point.axis_sum) || !extend_perimeter(e, polygon, st))
    return false;
  const bool young = polygon.young() && point.young() &&
                     may_be_young(e, polygon.moments.count() + point.moments.count(), polygon.fit);
  polygon.moments.add(point.moments);
  e.modelled_points += point.moments.count();
  polygon.axis_sum += point.axis_sum;
  polygon.variance_sum += point.variance_sum;
  polygon.since_sum += point.since_sum;
  if (young) {
    polygon.raw.insert(polygon.raw.end(), point.raw.begin(), point.raw.end());
  } else {
    mature(e, polygon);
    add_to_relief(e, *polygon.polygon, point);
  }
  forward_label(e, point.id, polygon.id);
  e.changes.push_back({Change::Kind::merged, polygon.id, point.id, polygon.id, {}});
  erase_segment(e, point);
  joined(e, polygon);
  return true;
}

}  // namespace limpet::model::internal
