// Copyright the limpet authors. GPL-3.0-or-later.
//
// A reading says where a surface is, and that there is none between it and the sensor.
#include "rays_internal.hpp"

#include <algorithm>
#include <cmath>

#include <limpet/geometry/predicates.hpp>
#include <limpet/geometry/search.hpp>

#include "engine_internal.hpp"
#include "lifted_internal.hpp"
#include "redundancy_internal.hpp"

namespace limpet::model::internal {
namespace {

using Eigen::Vector3d;

/// A polygon whose plane a reading has passed near it.
struct Passage {
  const Segment* segment;
  Vector3d at;
  bool through;
};

/// `ray` leads from the reading to the sensor, which is `range` away. `clear`: how far the reading must be
/// behind the plane, and the sensor before it.
std::optional<Passage> passage_of(const Setting& setting, const Segment& s, const SpatialIndex::Ray& ray,
                                  double range, double clear) {
  const Lifted polygon(*s.polygon);
  const Vector3d place = polygon.place(ray.from), along = polygon.direction(ray.axis);
  const double step = s.polygon->chart.step(), rise = polygon.rise(place), climb = polygon.climb(along),
               behind = polygon.height(rise) * step, before = behind + polygon.height(climb * range) * step;
  if (behind * before >= 0 || std::abs(behind) < clear || std::abs(before) < clear) return std::nullopt;
  const double t = -rise / climb;
  const Vector3d at = ray.at(t);
  if (!s.indexed.contains(at)) return std::nullopt;
  const geometry::Point2 p = geometry::round_to_grid({place.x() + t * along.x(), place.y() + t * along.y()});
  const bool through =
      polygon.inside(p) &&
      !geometry::nearest_perimeter_point(polygon.perimeter(), p, kPassedInside * setting.scale_at(at).gap);
  return Passage{&s, at, through};
}

/// One reading in so many is looked at, so that it costs little: all of a sparse scan.
std::int64_t stride_of(const Complex& complex) {
  const double area = complex.modelled_area();
  if (!(area > 0)) return 1;
  return std::max<std::int64_t>(
      1, static_cast<std::int64_t>(static_cast<double>(complex.modelled_points()) / (area * kLookedAt)));
}

/// Not in a pattern that a scanner's rows could have.
bool is_looked_at(std::int64_t now, std::int64_t stride) {
  const std::uint64_t mixed = static_cast<std::uint64_t>(now) * 0x9e3779b97f4a7c15u;
  return (mixed >> 32) % static_cast<std::uint64_t>(stride) == 0;
}

bool is_passed(const Segment& s) {
  return s.polygon && s.polygon->passages && !s.initial() && s.polygon->passages->rays() >= kFewestPassages &&
         kPassedShare * s.polygon->passages->through() >= s.count();
}

}  // namespace

void note_passages(Engine& e, const RawPoint& raw, double range) {
  if (!e.setting.rules().rays || !(range > 0) || !std::isfinite(range)) return;
  const std::int64_t stride = stride_of(e.complex);
  if (!is_looked_at(e.complex.now(), stride)) return;
  const SpatialIndex::Ray ray{e.setting.world(raw.at), -raw.axis};
  const double clear =
      std::max({e.setting.parameters.tolerance, kPassedBehind * e.setting.scale_at(ray.from).lambda,
                3 * std::sqrt(raw.variance)});
  std::vector<Passage> passages;
  const double slack = 2 * rounding_near(e.complex, Box3(ray.from));
  e.complex.polygons().walk(ray, range, slack, [&](std::uint32_t slot, double begin, double end) {
    const Segment& s = e.complex.at(slot);
    const auto enters = ray.entry(s.indexed);
    if (s.initial() || !enters || *enters < begin || *enters >= end) return range;
    const bool is_new =  // several cells of a piece may have it
        std::none_of(passages.begin(), passages.end(), [&](const Passage& one) { return one.segment == &s; });
    if (is_new)
      if (const auto passage = passage_of(e.setting, s, ray, range, clear)) passages.push_back(*passage);
    return range;
  });
  for (const Passage& passage : passages) {
    e.complex.note_passage(*passage.segment, passage.at, passage.through ? stride : 0);
    if (is_passed(*passage.segment)) e.agenda.note_passed(passage.segment->id);
  }
}

void delete_passed(Engine& e) {
  std::vector<SegmentId> ids = e.agenda.take_passed();
  std::sort(ids.begin(), ids.end());
  for (const SegmentId id : ids)
    if (const Segment* s = e.complex.find(id); s && is_passed(*s))
      e.counts.expired += delete_segment(e.complex, e.agenda, e.labels, *s);
}

}  // namespace limpet::model::internal
