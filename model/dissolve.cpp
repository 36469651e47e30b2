// Copyright the limpet authors. GPL-3.0-or-later.
//
// A young segment is dissolved if a fifth of its points fit mature neighbours, as those of a sliver across an
// edge do. Its points are inserted again.
#include <algorithm>
#include <cassert>

#include "dissolve_internal.hpp"
#include "promotion_internal.hpp"
#include "standing_internal.hpp"

namespace limpet::model::internal {
namespace {

Box3 box_of(const Setting& setting, std::span<const RawPoint> points) {
  Box3 box;
  for (const RawPoint& raw : points) box.extend(setting.world(raw.at));
  return box;
}

/// Does the polygon fit a point of the young segment that lies within λ of a place where the polygon has
/// changed?
bool fits_where_changed(const Setting& setting, const Segment& young, const Segment& polygon,
                        const DirtyRegion& changed) {
  const auto& raw_points = young.data.raw();
  return std::any_of(raw_points.begin(), raw_points.end(), [&](const RawPoint& raw) {
    const Eigen::Vector3d p = setting.world(raw.at);
    const double height = polygon.fit.height_of(p);
    const double lambda2 = setting.scale_at(p).lambda2;
    if (height * height >= lambda2) return false;
    const auto& places = changed.boxes();
    return std::any_of(places.begin(), places.end(),
                       [&](const Box3& place) { return place.squaredExteriorDistance(p) < lambda2; }) &&
           fits(setting, raw, polygon);
  });
}

/// Finds young segments whose points fit mature polygons.
class Misfits {
 public:
  Misfits(const Complex& complex, Agenda& agenda) : complex_(complex), agenda_(agenda) {}

  /// The young polygons that were modified, and all young segments near places where a mature polygon's
  /// description changed, by identity. Modified point segments need no look: their points were tried on all
  /// polygons when they came.
  Turn to_look_at() {
    Turn look;
    for (const std::uint32_t slot : agenda_.modified()) {
      const Segment* s = complex_.in_slot(slot);
      if (!s) continue;
      if (s->polygon && s->young()) look.emplace_back(s->id, slot);
      if (s->mature_polygon() && !agenda_.polygon(slot).changed.empty()) add_young_near(*s, look);
    }
    std::sort(look.begin(), look.end());
    look.erase(std::unique(look.begin(), look.end()), look.end());
    return look;
  }

  /// Do a fifth of the points fit mature neighbours? They are counted only if a point that has not been tried
  /// yet fits. Never true once a point has reached kMaxReturns.
  bool mostly_fits_neighbours(const Segment& s) {
    const auto fits_one = [&](const RawPoint& raw) {
      return std::any_of(polygons_.begin(), polygons_.end(),
                         [&](auto* polygon) { return fits(complex_.setting(), raw, *polygon); });
    };
    const std::span<const RawPoint> all(s.data.raw());
    const std::size_t seen = std::exchange(agenda_.seen(s.slot), all.size());
    const auto unseen = all.subspan(std::min(seen, all.size()));
    if (unseen.empty()) return false;
    find_mature_polygons(box_of(complex_.setting(), unseen));
    if (std::none_of(unseen.begin(), unseen.end(), fits_one)) return false;
    find_mature_polygons(box_of(complex_.setting(), all));
    std::size_t fitting = 0;
    for (const RawPoint& raw : all) {
      if (raw.returned >= kMaxReturns) return false;
      fitting += fits_one(raw);
    }
    return kFittingShare * fitting >= all.size();
  }

 private:
  void add_young_near(const Segment& polygon, Turn& look) {
    const DirtyRegion& changed = agenda_.polygon(polygon.slot).changed;
    for (const SpatialIndex* index : {&complex_.polygons(), &complex_.points()}) {
      query(*index, changed, found_);
      for (const std::uint32_t near : found_)
        if (const Segment& young = complex_.at(near);
            young.young() && fits_where_changed(complex_.setting(), young, polygon, changed)) {
          agenda_.seen(near) = 0;
          look.emplace_back(young.id, near);
        }
    }
  }

  /// Mature polygons that points in this box may fit.
  void find_mature_polygons(const Box3& around) {
    polygons_.clear();
    complex_.polygons().query(around, found_);
    for (const std::uint32_t slot : found_)
      if (const Segment& other = complex_.at(slot); other.mature_polygon()) polygons_.push_back(&other);
  }

  const Complex& complex_;
  Agenda& agenda_;
  std::vector<const Segment*> polygons_;
  std::vector<std::uint32_t> found_;
};

/// Did a young polygon of at least `from_count` points get them too slowly (rule `arrival`)? Asked at
/// promotion, and again shortly before it becomes mature.
bool came_too_slowly(const Complex& complex, const Segment& s, std::int64_t from_count) {
  return complex.rules().arrival && s.polygon && s.count() >= from_count &&
         too_few_arrived(complex, s.fit, s.data.sums().since);
}

}  // namespace

void release_points(Complex& complex, PendingPoints& pending, const Segment& s, bool count_return) {
  assert(static_cast<std::int64_t>(s.data.raw().size()) == s.count());
  for (RawPoint raw : s.data.raw()) {
    raw.returned += count_return;
    pending.push_back(raw);
  }
  complex.remove(s);
}

void release_slow_polygons(Complex& complex, Insertion& insertion) {
  Turn slow;
  complex.segments().for_each([&](const Segment& s) {
    if (s.young() && came_too_slowly(complex, s, 0)) slow.emplace_back(s.id, s.slot);
  });
  std::sort(slow.begin(), slow.end());
  for (const auto& [id, slot] : slow) {
    if (insertion.stopped()) return;
    if (const Segment* s = complex.find(id, slot)) release_points(complex, insertion.pending(), *s, false);
    insertion.insert_pending();
  }
}

void release_all_point_segments(Complex& complex, Insertion& insertion) {
  std::vector<SegmentId> ids;
  complex.segments().for_each([&](const Segment& s) {
    if (!s.polygon && s.young()) ids.push_back(s.id);
  });
  std::sort(ids.begin(), ids.end());
  for (const SegmentId id : ids) {
    if (insertion.stopped()) return;
    const Segment* s = complex.find(id);
    if (!s || s->polygon || !s->young()) continue;  // a point released before may have made it a polygon
    release_points(complex, insertion.pending(), *s, false);
    insertion.insert_pending();
  }
}

bool dissolve_young(Complex& complex, Agenda& agenda, Insertion& insertion) {
  if (!complex.rules().dissolve) return false;
  Misfits misfits(complex, agenda);
  bool any = false;
  for (const auto& [id, slot] : misfits.to_look_at()) {
    if (agenda.stopped()) break;
    const Segment* s = complex.find(id, slot);
    if (!s) continue;
    const bool slow = came_too_slowly(complex, *s, kYoung * 3 / 4);
    if (!slow && !misfits.mostly_fits_neighbours(*s)) continue;
    release_points(complex, insertion.pending(), *s, !slow);
    any = true;
  }
  insertion.insert_pending();
  return any;
}

}  // namespace limpet::model::internal
