// Copyright the limpet authors. GPL-3.0-or-later.
//
// The first hit of a ray. It walks along the spatial index, and each polygon is tested where the ray enters
// its box.
#include "first_hit_internal.hpp"

#include "outwards_internal.hpp"

namespace limpet::model::internal {
namespace {

using Eigen::Vector3d;

/// Where the ray meets the polygon, if within `range`.
std::optional<View::Hit> hit_of(const Segment& s, const Vector3d& from, const Vector3d& axis, double range) {
  const Lifted polygon(*s.polygon);
  const Vector3d place = polygon.place(from), along = polygon.direction(axis);
  const double rise = polygon.rise(place), climb = polygon.climb(along);
  if (climb == 0) return std::nullopt;
  const double t = rise == 0 ? 0 : -rise / climb;
  if (!(t >= 0 && t <= range)) return std::nullopt;
  const geometry::Point2 at{place.x() + t * along.x(), place.y() + t * along.y()};
  if (s.polygon->perimeter.locate(at) == geometry::Polygon::Side::outside) return std::nullopt;
  return View::Hit{polygon.world(at), t, s.id, climb < 0};
}

}  // namespace

std::optional<View::Hit> first_hit(const Complex& complex, const Vector3d& from, const Vector3d& axis,
                                   double range, const Which& which, double rounding) {
  const SpatialIndex::Ray ray{from, axis};
  std::optional<View::Hit> best;
  const auto look = [&](const Segment& s) {
    const auto hit = hit_of(s, from, axis, range);
    if (!hit || (best && hit->range == best->range && !(hit->segment < best->segment))) return;
    best = hit;
    range = hit->range;
  };
  if (which.only) {
    if (const Segment* s = the_only(complex, which); s && s->polygon) look(*s);
    return best;
  }
  if (!which.polygons && !which.initial) return best;
  complex.polygons().walk(ray, range, 2 * rounding, [&](std::uint32_t slot, double begin, double end) {
    const Segment& s = complex.at(slot);
    if (!is_asked(which, s)) return range;
    // A segment comes up in every piece of the ray near it; it is tested in the piece where the ray enters
    // its box.
    const auto enters = ray.entry(grown(s.polygon->box, room_around(complex, rounding)));
    if (enters && *enters >= begin && *enters < end && *enters <= range) look(s);
    return range;
  });
  return best;
}

}  // namespace limpet::model::internal
