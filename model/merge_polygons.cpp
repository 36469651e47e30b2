// Copyright the limpet authors. GPL-3.0-or-later.
//
// Merging two planar polygon segments (thesis §2.4.3).
#include <algorithm>
#include <cmath>

#include <limpet/geometry/merge.hpp>
#include <limpet/geometry/predicates.hpp>

#include "heights_internal.hpp"
#include "meeting_internal.hpp"
#include "merging_internal.hpp"
#include "pinches_internal.hpp"
#include "publish_internal.hpp"
#include "series_internal.hpp"
#include "sharing_internal.hpp"
#include "twins_internal.hpp"
#include "young_internal.hpp"

namespace limpet::model::internal {
namespace {

/// The largest λ where two polygons meet, if they do: between their boxes, and as far beside as that reaches.
Scale largest_between(const Setting& setting, const Box3& a, const Box3& b) {
  const Eigen::Vector3d low = a.min().cwiseMax(b.min()), high = a.max().cwiseMin(b.max());
  const Eigen::Vector3d centre = (low + high) / 2;
  const double half = (high - low).norm() / 2;
  return setting.largest_scale(centre, half + setting.largest_scale(centre, half).lambda);
}

/// λ in a polygon's chart.
geometry::Gap gap_in(const Setting& setting, const PolygonPart& part, const Scale& largest) {
  if (!setting.resolution_grows()) return largest.gap;
  return {[&](geometry::Point2 p) { return setting.scale_at(part.at(p)).gap; }, largest.gap};
}

bool within(const Box3& a, const Box3& b, double reach) {
  return a.squaredExteriorDistance(b) < reach * reach;
}

/// May the two lie in one plane, at first the published plane of `a`? The points of the one with fewer points
/// are judged by the plane of the other.
bool planes_agree(const Setting& setting, const Segment& a, const Segment& b) {
  const Segment& small = a.count() < b.count() ? a : b;
  const Segment& large = &small == &a ? b : a;
  double limit_rad = setting.parameters.angle_rad;
  if (setting.rules().residual) {
    const double ea = a.fit.normal_error(a.data.variance()), eb = b.fit.normal_error(b.data.variance());
    limit_rad = std::min(1.5, std::max(limit_rad, 3 * std::sqrt(ea * ea + eb * eb)));
  }
  const double cos_limit = limit_rad == setting.parameters.angle_rad ? setting.cos_angle : cosine(limit_rad);
  if (a.fit.normal.dot(b.fit.normal) <= cos_limit) return false;
  if (!faces_outside(a.polygon->outward, a.data.axis_sum() + b.data.axis_sum())) return false;
  if (setting.rules().residual) {
    const double residual2 = small.data.moments().squared_residual(large.fit.plane(), setting.step);
    const double by_noise =
        4 * small.data.variance() + 9 * large.fit.height_variance(small.fit.centroid, large.data.variance());
    const double tolerance2 = setting.parameters.tolerance * setting.parameters.tolerance;
    if (residual2 > std::max(by_noise, tolerance2) ||
        residual2 >= setting.scale_at(small.fit.centroid).lambda2)
      return false;
    if (residual2 > by_noise && setting.relief_kept() && !surfaces_continue(setting, large, small) &&
        !are_twins(setting, large, small, residual2))
      return false;
  }
  Moments merged = a.data.moments();
  merged.add(b.data.moments());
  if (!variance_allowed(setting, *a.polygon, merged)) return false;
  const Fit fit = fit_to(merged, setting.step, -large.fit.normal);
  return fit.u3 < setting.scale_at(fit.centroid).lambda2;
}

SegmentPair pair_of(const Segment& a, const Segment& b) { return std::minmax(a.id, b.id); }

/// The version numbers of the two descriptions, that of the lower identity first.
std::pair<std::uint64_t, std::uint64_t> shapes_of(const Segment& a, const Segment& b) {
  const bool in_order = a.id < b.id;
  return {(in_order ? a : b).polygon->shape, (in_order ? b : a).polygon->shape};
}

void remember_refusal(const Complex& complex, Agenda& agenda, const Segment& a, const Segment& b) {
  agenda.remember_refusal(pair_of(a, b), shapes_of(a, b));
  // When there are many entries, those with a segment that is gone are removed.
  if (agenda.refusals() > 2 * complex.segments().size() + 64)
    agenda.forget_refusals(
        [&](const SegmentPair& pair) { return !complex.find(pair.first) || !complex.find(pair.second); });
}

/// Where the merger is a change for other segments: at the new edges, and all over segments that were young
/// before.
DirtyRegion changed_region(const Segment& a, const Segment& b, const PlacedEdges& put) {
  DirtyRegion places = region_of(*a.polygon, put);
  for (const Segment* s : {&a, &b})
    if (s->young()) places.add(s->polygon->box);
  return places;
}

/// Without the rule `holes`, as in the thesis, a merger that leaves a hole fails.
geometry::Merger merge_perimeters(const Setting& setting, const geometry::Gap& gap, geometry::Polygon& a,
                                  const geometry::Polygon& b, geometry::EdgeIds& ids) {
  if (setting.rules().holes) return geometry::merge_polygons(a, b, gap, ids);
  geometry::Polygon trial = a;
  const auto merger = geometry::merge_polygons(trial, b, gap, ids);
  if (trial.hole_count() > 0) return geometry::Merger::refused;
  a = std::move(trial);
  return merger;
}

/// Moves everything else of b to a, whose perimeter is already that of both; `difference` says what that has
/// changed. Returns where the description has changed.
DirtyRegion take_over(Complex& complex, Agenda& agenda, const Segment& a, const Segment& b,
                      BoundaryDifference&& difference, const std::vector<geometry::EdgeId>& inherited) {
  auto& corners_due = agenda.polygon(a.slot).corners_due;
  corners_due.insert(corners_due.end(), inherited.begin(), inherited.end());
  DirtyRegion where = changed_region(a, b, difference.put);
  complex.extend_box(a, where);
  where.add(agenda.polygon(b.slot).changed);

  Moments merged = a.data.moments();
  merged.add(b.data.moments());
  const bool young =
      a.young() && b.young() &&
      may_be_young(complex.setting(), merged.count(), fit_to(merged, complex.setting().step, -a.fit.normal));
  complex.absorb_united(a, b, young);
  complex.tell(a, std::move(difference));
  return where;
}

/// The shared ones among edges that were put in place: they come from b, and are not on their new lines yet.
std::vector<geometry::EdgeId> shared_among(const geometry::Polygon& perimeter, const PlacedEdges& put) {
  std::vector<geometry::EdgeId> shared;
  for (const auto& [slot, edge] : put)
    if (perimeter.alive(slot) && perimeter.node(slot).shared) shared.push_back(edge);
  return shared;
}

}  // namespace

bool merge_polygon_segments(Complex& complex, Agenda& agenda, const Segment& s1, const Segment& s2) {
  const Setting& setting = complex.setting();
  const bool first_larger = s1.polygon->perimeter.edge_count() >= s2.polygon->perimeter.edge_count();
  const Segment &a = first_larger ? s1 : s2, &b = first_larger ? s2 : s1;
  if (a.initial() || b.initial()) return false;
  const Scale scale = largest_between(setting, a.polygon->box, b.polygon->box);
  if (!within(a.polygon->box, b.polygon->box, scale.lambda) || !planes_agree(setting, a, b) ||
      agenda.remembered_as_refused(pair_of(a, b), shapes_of(a, b)) ||
      !may_meet_where_changed(setting, s1, agenda.polygon(s1.slot).changed, s2) ||
      parted(setting, agenda, a, b))
    return false;
  const PolygonPart& part = *a.polygon;
  if (!part.shared.empty() && !b.polygon->shared.empty()) complex.dissolve_neighbours(a, b);
  auto other = in_chart(complex, part.chart, *b.polygon);
  if (!other) return remember_refusal(complex, agenda, a, b), false;
  other->take_created();
  const std::uint64_t joins_before = part.perimeter.joins();

  const geometry::Gap gap = gap_in(setting, part, scale);
  auto merger = geometry::Merger::refused;
  DirtyRegion where;
  std::vector<geometry::EdgeId> inherited;
  complex.with_ends_apart([&] {
    auto [outcome, difference] =
        complex.start_change(a, false, [&](geometry::Polygon& perimeter, geometry::EdgeIds& ids) {
          return merge_perimeters(setting, gap, perimeter, *other, ids);
        });
    merger = outcome;
    if (merger == geometry::Merger::too_far || merger == geometry::Merger::refused) return;
    inherited = shared_among(part.perimeter, difference.put);
    where = take_over(complex, agenda, a, b, std::move(difference), inherited);
    refit(complex, agenda, a);
    reposition(complex, a, inherited);
  });
  if (merger == geometry::Merger::too_far || merger == geometry::Merger::refused)
    return remember_refusal(complex, agenda, a, b), false;

  keep_one_concavity(complex, a, inherited);
  // A neighbour that shared edges with both may have them out of order now, as edges shared with others may
  // lie between them. Cycles of a that were joined may each have been in order, but not together.
  for (const std::uint32_t n : complex.neighbours_across(inherited))
    dissolve_disordered(complex, agenda, complex.at(n));
  if (!inherited.empty() || part.perimeter.joins() != joins_before) dissolve_disordered(complex, agenda, a);
  complex.set_initial_plane(a, a.fit.plane());
  complex.description_changed(a, where);
  complex.reindex(a);
  return true;
}

bool merge_modified_polygons(Complex& complex, Agenda& agenda) {
  bool any = false;
  const Turn turn = polygons_of(complex, agenda.modified(),
                                [&](const Segment& s) { return !agenda.polygon(s.slot).changed.empty(); });
  for (const auto& [id, slot] : turn) {
    if (agenda.stopped()) break;
    const Segment* s = complex.find(id, slot);
    if (!s) continue;  // it has merged in this round; the result is modified and has its turn in the next
    const Turn others = polygons_near(complex, agenda.polygon(slot).changed, slot);
    // The result of a merger has its own turn in the next round, with the changes of both.
    const bool merged = std::any_of(others.begin(), others.end(), [&](const auto& other) {
      return merge_polygon_segments(complex, agenda, *s, complex.at(other.second));
    });
    if (!merged) agenda.polygon(slot).changed.clear();
    any |= merged;
  }
  return any;
}

}  // namespace limpet::model::internal
