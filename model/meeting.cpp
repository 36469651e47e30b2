// Copyright the limpet authors. GPL-3.0-or-later.
//
// A cheap test before a polygon is projected into another's chart to be merged. Most polygons with
// neighbouring boxes do not meet, least of all where one of them has just changed.
#include <limpet/geometry/predicates.hpp>
#include <limpet/geometry/search.hpp>

#include "meeting_internal.hpp"

namespace limpet::model::internal {
namespace {

geometry::Point2 in_chart(const PolygonPart& to, const PolygonPart& from, geometry::Slot s) {
  const geometry::Point2 p = from.perimeter.at(s);
  return to.chart.project(from.chart.at(p, from.published(p)));
}

geometry::Slot some_vertex(const geometry::Polygon& polygon) {
  std::uint32_t i = 0;
  while (!polygon.alive(geometry::Slot{i})) ++i;
  return geometry::Slot{i};
}

bool holds(const PolygonPart& a, geometry::Point2 p) {
  return a.perimeter.locate(geometry::round_to_grid(p)) != geometry::Polygon::Side::outside;
}

/// A box in the chart around the projection of a world box.
geometry::Box2 seen_in(const geometry::Chart& chart, const Box3& box) {
  geometry::Box2 result;
  for (int corner = 0; corner < 8; ++corner)
    result.add(chart.project(box.corner(static_cast<Box3::CornerType>(corner))));
  return result;
}

/// Has `a`, in this box of its chart, an edge within λ of `b` or inside it?
bool edge_meets(const Setting& setting, const PolygonPart& a, const geometry::Box2& box,
                const PolygonPart& b) {
  return a.perimeter.any_edge_near(box, [&](geometry::Slot s) {
    const geometry::Point2 p = in_chart(b, a, s), q = in_chart(b, a, a.perimeter.next(s));
    const double gap = setting.scale_at(a.position(s)).gap;
    return geometry::any_edge_within(b.perimeter, p, q, gap + 2) || holds(b, p);
  });
}

}  // namespace

bool may_meet_where_changed(const Setting& setting, const Segment& s, const DirtyRegion& changed,
                            const Segment& other) {
  const PolygonPart &a = *s.polygon, &b = *other.polygon;
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(setting.largest_scale(b.box).lambda);
  const Box3 around(b.box.min() - reach, b.box.max() + reach);
  const bool near = std::any_of(changed.boxes().begin(), changed.boxes().end(), [&](const Box3& place) {
    const Box3 both = place.intersection(around);
    return !both.isEmpty() && edge_meets(setting, a, seen_in(a.chart, both).grown(2), b);
  });
  return near || holds(a, in_chart(a, b, some_vertex(b.perimeter)));
}

bool lies_near(const Setting& setting, const PolygonPart& part, const Eigen::Vector3d& p) {
  const double height = part.plane().height_of(p);
  const Scale scale = setting.scale_at(p);
  if (height * height >= scale.lambda2) return false;
  const geometry::Point2 q = geometry::round_to_grid(part.chart.project(p));
  if (part.perimeter.locate(q) != geometry::Polygon::Side::outside) return true;
  const double left = std::sqrt((scale.lambda2 - height * height) / scale.lambda2) * scale.gap;
  return geometry::nearest_perimeter_point(part.perimeter, q, left).has_value();
}

}  // namespace limpet::model::internal
