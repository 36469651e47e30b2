// Copyright the limpet authors. GPL-3.0-or-later.
//
// Merging two point segments (thesis §2.4.1), and promoting a patch of them.
#include <algorithm>
#include <numeric>

#include "engine_internal.hpp"

namespace limpet::model::internal {
namespace {

constexpr std::int64_t kPatch = 8;  ///< points that a patch has at least

/// Points of point segments around a new polygon may fit it now: each tries again on its own.
void release_neighbours(Engine& e, const Segment& polygon) {
  e.points.query(polygon.indexed, e.found);
  std::vector<std::pair<SegmentId, std::uint32_t>> near;
  for (const std::uint32_t slot : e.found) {
    Segment& s = e.at(slot);
    if (!s.polygon && s.young() && polygon.indexed.contains(s.fit.centroid)) near.emplace_back(s.id, slot);
  }
  std::sort(near.begin(), near.end());
  for (const auto& [id, slot] : near) release_points(e, e.at(slot), false);
}

void become_polygon(Engine& e, Segment& s, std::unique_ptr<PolygonPart> part) {
  promote(e, s, std::move(part));
  if (e.rules().dissolve) release_neighbours(e, s);
}

/// What remains to be done for a point segment whose data has gone to another.
void absorbed(Engine& e, Segment& into, Segment& from) {
  forward_label(e, from.id, into.id);
  e.changes.push_back({Change::Kind::merged, into.id, from.id, into.id, {}});
  erase_segment(e, from);
  mark_modified(e, into);
}

/// Young point segments within 2λ of a point segment, nearest first, ties by identity.
std::vector<Segment*> young_points_around(Engine& e, const Segment& seed) {
  const double reach = 2 * e.parameters.resolution;
  // Indexed boxes reach λ beyond what they hold.
  e.points.query(box_around(seed.fit.centroid, reach - e.parameters.resolution), e.found);
  std::vector<std::pair<double, Segment*>> near;
  for (const std::uint32_t slot : e.found) {
    Segment& s = e.at(slot);
    const double distance2 = (s.fit.centroid - seed.fit.centroid).squaredNorm();
    if (&s != &seed && !s.polygon && s.young() && distance2 < reach * reach) near.emplace_back(distance2, &s);
  }
  std::sort(near.begin(), near.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : a.second->id < b.second->id;
  });
  std::vector<Segment*> result;
  for (const auto& entry : near) result.push_back(entry.second);
  return result;
}

}  // namespace

PointMerger merge_point_segments(Engine& e, Segment& into, Segment& from) {
  if (into.axis_sum.dot(from.axis_sum) < 0) return PointMerger::refused;  // opposing sensing axes
  Moments moments = into.moments;
  moments.add(from.moments);
  const Eigen::Vector3d axis_sum = into.axis_sum + from.axis_sum;
  const double since_sum = into.since_sum + from.since_sum;
  const double variance_sum = into.variance_sum + from.variance_sum;
  const Fit fit = fit_to(moments, e.step, axis_sum);
  const double lambda2 = e.parameters.resolution * e.parameters.resolution;
  const bool small = fit.point_variance() < lambda2;
  const bool polygon = fit.u3 < lambda2 && promotable(e, fit, variance_sum / fit.count, axis_sum,
                                                      {&into.raw, &from.raw}, since_sum);
  auto part = polygon ? diamond_part(e, fit) : nullptr;
  if (!part && !small) return PointMerger::refused;

  const bool young = into.young() && from.young() && may_be_young(e, moments.count(), fit);
  into.moments = moments;
  into.axis_sum = axis_sum;
  into.fit = fit;
  into.since_sum = since_sum;
  into.variance_sum = variance_sum;
  if (young)
    into.raw.insert(into.raw.end(), from.raw.begin(), from.raw.end());
  else
    into.raw.clear();
  into.last_joined = e.counts.points;
  e.by_age.emplace_back(into.last_joined, into.id);
  absorbed(e, into, from);
  if (part) {
    become_polygon(e, into, std::move(part));
    return PointMerger::polygon;
  }
  update_index(e, into);
  return PointMerger::point;
}

bool promote_patch(Engine& e, Segment& seed) {
  if (!e.rules().promotion || !e.rules().patch || !seed.young()) return false;
  const auto around = young_points_around(e, seed);
  const auto add_count = [](std::int64_t sum, const Segment* s) { return sum + s->moments.count(); };
  if (std::accumulate(around.begin(), around.end(), seed.moments.count(), add_count) < kPatch) return false;
  Moments moments = seed.moments;
  Eigen::Vector3d axis_sum = seed.axis_sum;
  double since_sum = seed.since_sum, variance_sum = seed.variance_sum;
  std::vector<const std::vector<RawPoint>*> raw{&seed.raw};
  std::vector<Segment*> patch;
  for (Segment* s : around) {
    if (s->axis_sum.dot(axis_sum) < 0 || moments.count() + s->moments.count() > kYoung) continue;
    Moments trial = moments;
    trial.add(s->moments);
    const Fit fit = fit_to(trial, e.step, axis_sum + s->axis_sum);
    const double variance = (variance_sum + s->variance_sum) / fit.count;
    // Across an edge, or with an outlier, the points are no plane any more: that neighbour stays out.
    if (trial.count() > 5 && fit.u3 > 4 * variance * (fit.count - 3) / fit.count) continue;
    moments = trial;
    axis_sum += s->axis_sum;
    since_sum += s->since_sum;
    variance_sum += s->variance_sum;
    raw.push_back(&s->raw);
    patch.push_back(s);
    if (moments.count() < kPatch || !promotable(e, fit, variance, axis_sum, raw, since_sum)) continue;
    auto part = diamond_part(e, fit);
    if (!part) return false;
    seed.moments = moments;
    seed.axis_sum = axis_sum;
    seed.fit = fit;
    seed.since_sum = since_sum;
    seed.variance_sum = variance_sum;
    for (Segment* joined : patch) {
      seed.raw.insert(seed.raw.end(), joined->raw.begin(), joined->raw.end());
      absorbed(e, seed, *joined);
    }
    seed.last_joined = e.counts.points;
    become_polygon(e, seed, std::move(part));
    return true;
  }
  return false;
}

}  // namespace limpet::model::internal
