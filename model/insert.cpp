// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>

#include "engine_internal.hpp"

namespace limpet::model::internal {
namespace {

struct Candidate {
  double distance2;  ///< by which they are ordered, squared
  SegmentId id;
  Segment* segment;
  Standing standing;
};

/// Nearest first, ties by identity; with the thesis's rules in the order of memory.
void order(const Engine& e, std::vector<Candidate>& candidates) {
  std::sort(candidates.begin(), candidates.end(), [&](const Candidate& a, const Candidate& b) {
    if (e.rules().best && a.distance2 != b.distance2) return a.distance2 < b.distance2;
    return a.id < b.id;
  });
}

void add_polygon(const Engine& e, Segment& s, const Eigen::Vector3d& p, const Eigen::Vector3d& axis,
                 double residual2, double variance, std::vector<Candidate>& candidates) {
  if (s.initial()) return;
  const Standing st = standing(e, s, p, axis, residual2, variance);
  if (st.near) candidates.push_back({st.distance2, s.id, &s, st});
}

/// Of several polygons that data at p fits, the one whose surface, as it lies there, is nearest comes first.
void order_by_relief(const Engine& e, const Eigen::Vector3d& p, std::vector<Candidate>& polygons) {
  if (polygons.size() < 2) return;
  if (relief_kept(e))
    for (Candidate& c : polygons) {
      const auto local = c.segment->mature_polygon() ? local_residual(e, *c.segment, p) : std::nullopt;
      const double height = local ? local->height : c.segment->fit.height_of(p);
      c.distance2 = height * height;
    }
  order(e, polygons);
}

/// Point segments within λ of s, and polygons that it fits if these are still to be tried.
void neighbours(Engine& e, Segment& s, bool polygons_tried, std::vector<Candidate>& polygons,
                std::vector<Candidate>& points) {
  polygons.clear(), points.clear();
  const Eigen::Vector3d centroid = s.fit.centroid;
  const double lambda2 = e.parameters.resolution * e.parameters.resolution;
  e.points.query(centroid, e.found);
  for (const std::uint32_t slot : e.found) {
    Segment& other = e.at(slot);
    const double d2 = (other.fit.centroid - centroid).squaredNorm();
    if (&other != &s && d2 < lambda2) points.push_back({d2, other.id, &other, {}});
  }
  if (!polygons_tried) {
    e.polygons.query(centroid, e.found);
    for (const std::uint32_t slot : e.found) {
      Segment& other = e.at(slot);
      const double residual2 = s.moments.squared_residual(other.fit.plane(), e.step);
      add_polygon(e, other, centroid, s.axis_sum, residual2, s.variance(), polygons);
    }
  }
  order_by_relief(e, centroid, polygons);
  if (!e.rules().best)
    polygons.insert(polygons.end(), points.begin(), points.end()), points.clear(), order(e, polygons);
  order(e, points);
}

/// A new point segment tries its neighbours until it has merged into a polygon or fits no other any more.
void settle(Engine& e, Segment* s, bool polygons_tried) {
  static thread_local std::vector<Candidate> polygons, points;
  for (;;) {
    neighbours(e, *s, polygons_tried, polygons, points);
    // A fitting polygon beats a nearer point segment.
    polygons.insert(polygons.end(), points.begin(), points.end());
    Segment* next = nullptr;
    for (const Candidate& c : polygons) {
      if (c.segment->polygon) {
        if (merge_segment_into_polygon(e, *c.segment, *s, c.standing)) return;
        continue;
      }
      const PointMerger merger = merge_point_segments(e, *c.segment, *s);
      if (merger == PointMerger::polygon) return;
      if (merger == PointMerger::point) {
        next = c.segment;
        break;
      }
    }
    if (!next) {
      update_index(e, *s);
      promote_patch(e, *s);
      return;
    }
    s = next;
    polygons_tried = false;
  }
}

}  // namespace

void insert_point(Engine& e, const RawPoint& raw) {
  static thread_local std::vector<Candidate> candidates;
  candidates.clear();
  const Eigen::Vector3d p = e.world(raw.at);
  const bool best = e.rules().best;
  const double lambda2 = e.parameters.resolution * e.parameters.resolution;
  if (best)
    e.polygons.query(p, e.found);
  else
    e.found.clear();
  for (const std::uint32_t slot : e.found) {
    Segment& s = e.at(slot);
    const double height = s.fit.height_of(p);
    if (height * height < lambda2) add_polygon(e, s, p, raw.axis, height * height, raw.variance, candidates);
  }
  order_by_relief(e, p, candidates);
  for (const Candidate& c : candidates)
    if (merge_point_into_polygon(e, *c.segment, raw, c.standing)) return;
  settle(e, &create_point_segment(e, raw), best);
}

void insert_pending(Engine& e) {
  while (!e.pending.empty()) {
    const RawPoint raw = e.pending.front();
    e.pending.pop_front();
    insert_point(e, raw);
  }
}

}  // namespace limpet::model::internal
