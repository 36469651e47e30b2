// Copyright the limpet authors. GPL-3.0-or-later.
#include "insertion_internal.hpp"

#include <algorithm>
#include <cmath>

#include "heights_internal.hpp"
#include "merging_internal.hpp"
#include "promotion_internal.hpp"

namespace limpet::model::internal {

/// Nearest first, ties by identity. Without the rule `best`, by identity alone.
void Insertion::order(Candidates& candidates) const {
  std::sort(candidates.begin(), candidates.end(), [&](const Candidate& a, const Candidate& b) {
    if (complex_.rules().best && a.distance2 != b.distance2) return a.distance2 < b.distance2;
    return a.id < b.id;
  });
}

void Insertion::add_polygon(const Segment& s, const Eigen::Vector3d& p, const Eigen::Vector3d& axis,
                            double residual2, double variance, Candidates& candidates) const {
  if (s.initial()) return;
  const Standing st = standing(complex_.setting(), s, p, axis, residual2, variance);
  if (st.near) candidates.push_back({st.distance2, s.id, &s, st});
}

/// Orders several polygons that data at p fits by the height of p over their surface there (its height map,
/// if known, else its plane).
void Insertion::order_by_heights(const Eigen::Vector3d& p, Candidates& polygons) const {
  if (complex_.setting().relief_kept())
    for (Candidate& c : polygons) {
      const auto local =
          c.segment->mature_polygon() ? local_residual(complex_.setting(), *c.segment, p) : std::nullopt;
      const double height = local ? local->height : c.segment->fit.height_of(p);
      c.distance2 = height * height;
    }
  order(polygons);
}

/// Lists the point segments within λ of s and, unless they have been tried, the polygons that it fits.
void Insertion::find_neighbours(const Segment& s, bool polygons_tried) {
  Candidates &polygons = near_, &points = near_points_;
  polygons.clear(), points.clear();
  const Eigen::Vector3d centroid = s.fit.centroid;
  const double lambda2 = complex_.setting().scale_at(centroid).lambda2;
  complex_.points().query(centroid, found_);
  for (const std::uint32_t slot : found_) {
    const Segment& other = complex_.at(slot);
    const double d2 = (other.fit.centroid - centroid).squaredNorm();
    if (&other != &s && d2 < lambda2) points.push_back({d2, other.id, &other, {}});
  }
  if (!polygons_tried) {
    complex_.polygons().query(centroid, found_);
    for (const std::uint32_t slot : found_) {
      const Segment& other = complex_.at(slot);
      const double residual2 = s.data.moments().squared_residual(other.fit.plane(), complex_.setting().step);
      add_polygon(other, centroid, s.data.axis_sum(), residual2, s.data.variance(), polygons);
    }
  }
  if (polygons.size() > 1) order_by_heights(centroid, polygons);
  if (!complex_.rules().best)
    polygons.insert(polygons.end(), points.begin(), points.end()), points.clear(), order(polygons);
  order(points);
  // A fitting polygon beats a nearer point segment.
  polygons.insert(polygons.end(), points.begin(), points.end());
}

/// Merges a point segment with its neighbours, until it has become part of a polygon or none of them takes
/// it.
void Insertion::settle(const Segment* s, bool polygons_tried) {
  for (;;) {
    find_neighbours(*s, polygons_tried);
    const Segment* next = nullptr;
    for (const Candidate& c : near_) {
      if (c.segment->polygon) {
        if (merge_segment_into_polygon(complex_, agenda_, *c.segment, *s, c.standing)) return;
        continue;
      }
      const PointMerger merger = merge_point_segments(complex_, agenda_, pending_, *c.segment, *s);
      if (merger == PointMerger::polygon) return;
      if (merger == PointMerger::point) {
        next = c.segment;
        break;
      }
    }
    if (!next) {
      complex_.reindex(*s);
      promote_patch(complex_, agenda_, pending_, *s);
      return;
    }
    s = next;
    polygons_tried = false;
  }
}

/// The initial segment, of those found, that a point lies on: the nearest, ties by identity. Null: on none.
const Segment* Insertion::initial_under(const Eigen::Vector3d& p, const RawPoint& raw) const {
  const Segment* best = nullptr;
  double least = 0;
  for (const std::uint32_t slot : found_) {
    const Segment& s = complex_.at(slot);
    if (!s.initial() || !lies_on_initial(complex_.setting(), s, p, raw.axis, raw.variance)) continue;
    const double height = std::abs(s.fit.height_of(p));
    if (best && (height != least ? height > least : s.id > best->id)) continue;
    best = &s, least = height;
  }
  return best;
}

/// Of the polygons that a point fits, which lies on an initial segment, leaves those that come before it:
/// they cross it, and the point is nearer to them. So a neighbour gets its points up to the common line, and
/// a polygon in the plane of the initial segment does not grow over it.
void Insertion::keep_nearer_crossing(const Segment& initial, const Eigen::Vector3d& p,
                                     Candidates& polygons) const {
  const double height = std::abs(initial.fit.height_of(p));
  std::erase_if(polygons, [&](const Candidate& c) {
    const Fit& fit = c.segment->fit;
    return std::abs(fit.height_of(p)) >= height ||
           fit.normal.dot(initial.fit.normal) >= complex_.setting().cos_angle;
  });
}

void Insertion::insert_one(const RawPoint& raw) {
  candidates_.clear();
  const Eigen::Vector3d p = complex_.setting().world(raw.at);
  const bool best = complex_.rules().best, any_initial = complex_.initial_count() > 0;
  if (best || any_initial)
    complex_.polygons().query(p, found_);
  else
    found_.clear();
  const Segment* initial = any_initial ? initial_under(p, raw) : nullptr;
  if (best) {
    const double lambda2 = complex_.setting().scale_at(p).lambda2;
    for (const std::uint32_t slot : found_) {
      const Segment& s = complex_.at(slot);
      const double height = s.fit.height_of(p);
      if (height * height < lambda2) add_polygon(s, p, raw.axis, height * height, raw.variance, candidates_);
    }
  }
  if (initial) keep_nearer_crossing(*initial, p, candidates_);
  if (candidates_.size() > 1) order_by_heights(p, candidates_);
  for (const Candidate& c : candidates_)
    if (merge_point_into_polygon(complex_, agenda_, *c.segment, raw, c.standing))
      return labels_.set(raw, c.segment->id);
  if (initial) {
    complex_.confirm(*initial);
    return labels_.set(raw, initial->id);
  }
  settle(&create_alone(raw), best);
}

/// A point segment of this point alone.
const Segment& Insertion::create_alone(const RawPoint& raw) {
  const Segment& s = complex_.create_point_segment(raw);
  agenda_.note_age(s.id, complex_.now());
  labels_.set(raw, s.id);
  return s;
}

void Insertion::insert(const RawPoint& raw) {
  insert_one(raw);
  insert_pending();
}

void Insertion::insert_as_polygon(const std::vector<RawPoint>& points) {
  const std::uint32_t slot = create_alone(points.front()).slot;
  for (auto raw = points.begin() + 1; raw != points.end(); ++raw) {
    const Segment& joining = create_alone(*raw);
    complex_.absorb(complex_.at(slot), joining, true);
  }
  const Segment& s = complex_.at(slot);
  complex_.set_fit(s, fit_to(s.data.moments(), complex_.setting().step, s.data.axis_sum()), s.next_fit);
  if (auto part = diamond_part(complex_, s.fit)) promote(complex_, s, std::move(part));
}

void Insertion::insert_pending() {
  while (!pending_.empty()) {
    const RawPoint raw = pending_.front();
    pending_.pop_front();
    insert_one(raw);
  }
}

}  // namespace limpet::model::internal
