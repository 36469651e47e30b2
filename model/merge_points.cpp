// Copyright the limpet authors. GPL-3.0-or-later.
//
// Merging two point segments (thesis §2.4.1), and promoting a patch of them.
#include <algorithm>
#include <numeric>

#include "merging_internal.hpp"
#include "promotion_internal.hpp"
#include "young_internal.hpp"

namespace limpet::model::internal {
namespace {

/// Dissolves the young point segments around a new polygon: each of their points is inserted again and may
/// fit it now.
void release_neighbours(Complex& complex, PendingPoints& pending, const Segment& polygon) {
  Turn near;
  complex.points().any_of(polygon.indexed, [&](std::uint32_t slot) {
    const Segment& s = complex.at(slot);
    if (s.young() && polygon.indexed.contains(s.fit.centroid)) near.emplace_back(s.id, slot);
    return false;
  });
  std::sort(near.begin(), near.end());
  for (const auto& [id, slot] : near) release_points(complex, pending, complex.at(slot), false);
}

void become_polygon(Complex& complex, PendingPoints& pending, const Segment& s,
                    std::unique_ptr<PolygonPart> part) {
  promote(complex, s, std::move(part));
  if (complex.rules().dissolve) release_neighbours(complex, pending, s);
}

/// Young point segments within 2λ of a point segment, nearest first, ties by identity.
std::vector<const Segment*> young_points_around(const Complex& complex, const Segment& seed) {
  const Setting& setting = complex.setting();
  const double lambda = setting.scale_at(seed.fit.centroid).lambda, reach = 2 * lambda;
  // Boxes in the index reach at least λ beyond their segments: λ where these are, which is less by no more
  // than what it grows by on the way.
  const double least = lambda - reach * setting.parameters.resolution_per_range;
  std::vector<std::pair<double, const Segment*>> near;
  complex.points().any_of(box_around(seed.fit.centroid, reach - least), [&](std::uint32_t slot) {
    const Segment& s = complex.at(slot);
    const double distance2 = (s.fit.centroid - seed.fit.centroid).squaredNorm();
    if (&s != &seed && s.young() && distance2 < reach * reach) near.emplace_back(distance2, &s);
    return false;
  });
  std::sort(near.begin(), near.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : a.second->id < b.second->id;
  });
  std::vector<const Segment*> result;
  for (const auto& entry : near) result.push_back(entry.second);
  return result;
}

}  // namespace

PointMerger merge_point_segments(Complex& complex, Agenda& agenda, PendingPoints& pending,
                                 const Segment& into, const Segment& from) {
  const Setting& setting = complex.setting();
  if (into.data.axis_sum().dot(from.data.axis_sum()) < 0) return PointMerger::refused;  // opposing axes
  SegmentData::Sums sums = into.data.sums();
  sums += from.data.sums();
  const Fit fit = fit_to(sums.moments, setting.step, sums.axis);
  const double lambda2 = setting.scale_at(fit.centroid).lambda2;
  const bool small = fit.point_variance() < lambda2;
  const bool polygon =
      fit.u3 < lambda2 && promotable(complex, fit, sums, {&into.data.raw(), &from.data.raw()});
  auto part = polygon ? diamond_part(complex, fit) : nullptr;
  if (!part && !small) return PointMerger::refused;

  const bool young = into.young() && from.young() && may_be_young(setting, sums.moments.count(), fit);
  complex.set_fit(into, fit, into.next_fit);
  complex.absorb(into, from, young);
  agenda.note_age(into.id, complex.now());
  agenda.mark_modified(into.slot);
  if (part) {
    become_polygon(complex, pending, into, std::move(part));
    return PointMerger::polygon;
  }
  complex.reindex(into);
  return PointMerger::point;
}

bool promote_patch(Complex& complex, Agenda& agenda, PendingPoints& pending, const Segment& seed) {
  if (!complex.rules().promotion || !complex.rules().patch || !seed.young()) return false;
  const auto around = young_points_around(complex, seed);
  const auto add_count = [](std::int64_t sum, const Segment* s) { return sum + s->count(); };
  if (std::accumulate(around.begin(), around.end(), seed.count(), add_count) < kPatch) return false;
  SegmentData::Sums sums = seed.data.sums();
  std::vector<const std::vector<RawPoint>*> raw{&seed.data.raw()};
  std::vector<const Segment*> patch;
  for (const Segment* s : around) {
    if (s->data.axis_sum().dot(sums.axis) < 0 || sums.moments.count() + s->count() > kYoung) continue;
    SegmentData::Sums trial = sums;
    trial += s->data.sums();
    const Fit fit = fit_to(trial.moments, complex.setting().step, trial.axis);
    const double variance = trial.variance / fit.count;
    // If the points are no plane any more, across an edge or with an outlier, this neighbour stays out.
    if (trial.moments.count() > 5 && fit.u3 > 4 * variance * (fit.count - 3) / fit.count) continue;
    sums = trial;
    raw.push_back(&s->data.raw());
    patch.push_back(s);
    if (sums.moments.count() < kPatch || !promotable(complex, fit, sums, raw)) continue;
    auto part = diamond_part(complex, fit);
    if (!part) return false;
    complex.set_fit(seed, fit, seed.next_fit);
    for (const Segment* joined : patch) {
      complex.absorb(seed, *joined, true);
      agenda.mark_modified(seed.slot);
    }
    become_polygon(complex, pending, seed, std::move(part));
    return true;
  }
  return false;
}

}  // namespace limpet::model::internal
