// Copyright the limpet authors. GPL-3.0-or-later.
//
// Deleting redundant segments (thesis §2.9): small ones between others, that merge with none of them and find
// no edge to share. Their data goes where it still fits.
#include <algorithm>

#include "engine_internal.hpp"

namespace limpet::model::internal {
namespace {

using geometry::Slot;

constexpr double kSameWay = 0.5;  ///< cosine of 60°

/// Is a point of a segment with this normal within λ of the other's surface, facing about the same way? A
/// thin plate has a back, and the perimeter of a small face of a box lies all on the faces around it; a
/// sliver across an edge turns by half of the angle there.
bool lies_on(const Engine& e, const Segment& other, const Eigen::Vector3d& p, const Eigen::Vector3d& normal) {
  return other.polygon->outward.dot(normal) > kSameWay && lies_near(e, *other.polygon, p);
}

/// A patch or a sliver: what is larger, and wider, is a surface of its own however near others are.
bool is_small(const Engine& e, const PolygonPart& part) {
  const double area = part.perimeter.area() / (e.gap * e.gap),
               length = part.box.diagonal().norm() / e.parameters.resolution;
  return area < kYoungArea || area < 1.5 * length;
}

/// By position: do all vertices of a small segment lie within λ of surfaces of larger ones?
bool lies_on_others(Engine& e, const Segment& s) {
  const PolygonPart& part = *s.polygon;
  if (!is_small(e, part)) return false;
  e.polygons.query(part.box, e.found);
  std::vector<const Segment*> others;
  for (const std::uint32_t slot : e.found)
    if (const Segment& other = e.at(slot); other.moments.count() > s.moments.count())
      others.push_back(&other);
  for (std::uint32_t i = 0; i < part.perimeter.slot_count(); ++i) {
    if (!part.perimeter.alive(Slot{i})) continue;
    const Eigen::Vector3d p = part.position(Slot{i});
    if (std::none_of(others.begin(), others.end(),
                     [&](const Segment* other) { return lies_on(e, *other, p, part.outward); }))
      return false;
  }
  return !others.empty();
}

/// The polygon that the data fits best, with how it stands to it.
std::pair<Segment*, Standing> best_for(Engine& e, const Segment& but, const Eigen::Vector3d& p,
                                       const Eigen::Vector3d& axis, const Moments& data, double variance) {
  std::pair<Segment*, Standing> best{nullptr, {}};
  e.polygons.query(p, e.found);
  std::sort(e.found.begin(), e.found.end(),
            [&](std::uint32_t a, std::uint32_t b) { return e.at(a).id < e.at(b).id; });
  for (const std::uint32_t slot : e.found) {
    Segment& other = e.at(slot);
    if (&other == &but || other.initial()) continue;
    const Standing st =
        standing(e, other, p, axis, data.squared_residual(other.fit.plane(), e.step), variance);
    if (st.near && (!best.first || st.distance2 < best.second.distance2)) best = {&other, st};
  }
  return best;
}

/// Deletes the segment; its data goes to a segment that it fits as a whole, else its points go, one by one,
/// to those that they fit. What fits nowhere is given up.
void delete_segment(Engine& e, Segment& s) {
  dissolve_all_neighbours(e, s);
  if (s.moments.count() > 0)
    if (const auto [other, st] = best_for(e, s, s.fit.centroid, s.axis_sum, s.moments, s.variance());
        other && merge_segment_into_polygon(e, *other, s, st))
      return;
  const std::vector<RawPoint> raw = s.raw;
  std::int64_t lost = s.moments.count() - static_cast<std::int64_t>(raw.size());
  e.changes.push_back({Change::Kind::deleted, s.id, {}, {}, {}});
  erase_segment(e, s);
  for (const RawPoint& point : raw) {
    const Segment none;
    const auto [other, st] =
        best_for(e, none, e.world(point.at), point.axis, Moments(point.at), point.variance);
    if (!(other && merge_point_into_polygon(e, *other, point, st))) ++lost;
  }
  e.counts.expired += lost;
}

}  // namespace

void note_if_redundant(Engine& e, const Segment& a, const Segment& b) {
  const Segment& small = a.moments.count() < b.moments.count() ? a : b;
  const auto n1 = static_cast<double>(small.moments.count()),
             n2 = static_cast<double>(std::max(a.moments.count(), b.moments.count()));
  if (n1 > 0 && n1 < e.parameters.redundancy_count && n1 < e.parameters.redundancy_ratio * n2)
    e.redundant.push_back(small.id);
}

bool delete_redundant(Engine& e) {
  std::vector<SegmentId> ids = std::exchange(e.redundant, {});
  const std::size_t by_count = ids.size();
  if (e.finishing && e.rules().position)
    for (const auto& s : e.segments)
      if (s && s->polygon && s->polygon->shared.empty() && s->moments.count() > 0) ids.push_back(s->id);
  std::sort(ids.begin() + static_cast<std::ptrdiff_t>(by_count), ids.end());
  bool any = false;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    Segment* s = e.find(ids[i]);
    if (!s || !s->polygon || !s->polygon->shared.empty() || (i >= by_count && !lies_on_others(e, *s)))
      continue;
    ++(i < by_count ? e.counts.redundant_by_count : e.counts.redundant_by_position);
    delete_segment(e, *s);
    any = true;
  }
  return any;
}

}  // namespace limpet::model::internal
