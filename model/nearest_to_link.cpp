// Copyright the limpet authors. GPL-3.0-or-later.
//
// The point of a segment nearest to the axis of a link. An axis that crosses the inside of a polygon has
// distance 0. Else one point of the nearest pair is an end of the axis over the inside, or lies on the
// perimeter.
#include <array>

#include "lifted_internal.hpp"
#include "nearest_internal.hpp"
#include "piece_internal.hpp"

namespace limpet::model::internal {
namespace {

using Eigen::Vector3d;
using geometry::Point2;
using geometry::Slot;

/// A point on each of two pieces, as parameters from 0 to 1, and their squared distance.
struct Places2 {
  double s = 0, t = 0, squared = 0;
};

Places2 places(const Piece& p, const Piece& q, double s, double t) {
  const Vector3d d = p.at(s) - q.at(t);
  return {s, t, d.dot(d)};
}

/// The feet of the common perpendicular of the two lines, if both are between the ends.
std::optional<Places2> across(const Piece& p, const Piece& q) {
  const Vector3d u = p.b - p.a, v = q.b - q.a, n = u.cross(v);
  const double nn = n.dot(n);
  if (!(nn > 0)) return std::nullopt;
  double s = 0, t = 0;
  // A second round removes most of the rounding error of the first where the lines are nearly parallel.
  for (int round = 0; round < 2; ++round) {
    const Vector3d w = (q.a + t * v) - (p.a + s * u);
    s += w.cross(v).dot(n) / nn, t += w.cross(u).dot(n) / nn;
  }
  if (!(s > 0 && s < 1 && t > 0 && t < 1)) return std::nullopt;
  return places(p, q, s, t);
}

/// The pair of points of the two pieces that are nearest to each other.
Places2 nearest_places(const Piece& p, const Piece& q) {
  Places2 best = places(p, q, 0, q.nearest(p.a));
  const auto offer = [&](const Places2& other) {
    if (other.squared < best.squared) best = other;
  };
  offer(places(p, q, 1, q.nearest(p.b)));
  offer(places(p, q, p.nearest(q.a), 0));
  offer(places(p, q, p.nearest(q.b), 1));
  if (const auto between = across(p, q)) offer(*between);
  return best;
}

/// The nearest point of a polygon (chart point), and its place on the axis.
struct Found {
  Point2 at;
  double fraction = 0, squared = 0;  ///< part of the axis; squared distance from it, grid steps
  geometry::EdgeId edge;
  double side = 1;  ///< if `at` is inside: the side of the plane the axis is on, ±1
  bool crossing = false;
};

/// The axis of a link and a polygon, in the frame of the polygon's chart (Lifted).
class AxisAndPolygon {
 public:
  AxisAndPolygon(const Lifted& polygon, const Capsule& link)
      : polygon_(polygon), axis_{polygon.place(link.a), polygon.place(link.b)} {
    const std::array<double, 2> rise{polygon.rise(axis_.a), polygon.rise(axis_.b)};
    for (std::size_t i = 0; i < 2; ++i) {
      height_[i] = polygon.height(rise[i]);
      foot_[i] = polygon.foot(i == 0 ? axis_.a : axis_.b, rise[i]);
    }
  }

  /// Distance of the axis from the plane: that of its nearer end, or 0 when it crosses the plane.
  double height() const { return crosses() ? 0 : std::min(std::abs(height_[0]), std::abs(height_[1])); }

  std::optional<Found> nearest(double limit, double slack) const {
    if (height() > limit + slack) return std::nullopt;
    if (auto found = crossing()) return found;
    std::optional<Found> best = over_inside();
    // No point of the polygon can be nearer than its plane.
    if (best && std::sqrt(best->squared) <= height()) return best;
    look_at_perimeter(best, limit, slack);
    return best;
  }

 private:
  bool crosses() const {
    return (height_[0] <= 0 && height_[1] >= 0) || (height_[0] >= 0 && height_[1] <= 0);
  }

  /// The point where the axis goes through the inside of the polygon.
  std::optional<Found> crossing() const {
    if (!crosses()) return std::nullopt;
    const double whole = height_[0] - height_[1];
    Found found;
    found.fraction = whole == 0 ? 0 : height_[0] / whole;
    found.crossing = true;
    const Vector3d p = axis_.at(found.fraction);
    found.at = {p.x(), p.y()};
    if (!polygon_.inside(found.at)) return std::nullopt;
    return found;
  }

  /// The foot of the nearer one of the axis's ends that are over the inside.
  std::optional<Found> over_inside() const {
    std::optional<Found> best;
    for (std::size_t i = 0; i < 2; ++i) {
      if (best && height_[i] * height_[i] >= best->squared) continue;
      if (!polygon_.inside(foot_[i])) continue;
      const double side = height_[i] < 0 ? -1 : 1;
      best = Found{foot_[i], static_cast<double>(i), height_[i] * height_[i], {}, side, false};
    }
    return best;
  }

  void look_at_perimeter(std::optional<Found>& best, double limit, double slack) const {
    const geometry::Polygon& perimeter = polygon_.perimeter();
    const geometry::Box2 feet = box_of(foot_[0], foot_[1]);
    if (best) limit = std::min(limit, std::sqrt(best->squared));
    double within = reach_on_plane(limit, height(), slack);
    look_at_edges_near(perimeter, feet, within, slack, [&](Slot s) {
      const geometry::EdgeId edge = perimeter.node(s).edge;
      if (best && best->edge == edge) return within;  // it comes from several cells
      const Point2 a = perimeter.at(s), b = perimeter.end(s);
      if (!box_of(a, b).meets(feet.grown(within + slack))) return within;
      const Places2 found = nearest_places(axis_, {polygon_.lifted(a), polygon_.lifted(b)});
      if (best && (found.squared > best->squared || (found.squared == best->squared && !(edge < best->edge))))
        return within;
      best = Found{found.t == 1 ? b : a + found.t * (b - a), found.s, found.squared, edge};
      within = std::min(within, reach_on_plane(std::sqrt(found.squared), height(), slack));
      return within;
    });
  }

  const Lifted& polygon_;
  Piece axis_;
  std::array<double, 2> height_{};
  std::array<Point2, 2> foot_{};
};

std::optional<View::LinkNearest> nearest_on(const PolygonPart& part, const Capsule& link, double limit,
                                            double rounding) {
  const Lifted polygon(part);
  const double step = part.chart.step();
  const auto found = AxisAndPolygon(polygon, link).nearest(limit / step, rounding / step);
  if (!found) return std::nullopt;
  View::LinkNearest result;
  result.fraction = found->fraction;
  result.on_axis = Piece{link.a, link.b}.at(found->fraction);
  result.at = found->crossing ? result.on_axis : polygon.world(found->at);
  result.edge = found->edge;
  result.distance = length(result.at - result.on_axis);
  if (found->edge && result.distance > 0)
    result.away = (result.on_axis - result.at) / result.distance;
  else
    result.away = found->side * polygon.normal();
  return result;
}

View::LinkNearest nearest_on_point(const Segment& s, const Capsule& link) {
  View::LinkNearest result;
  result.at = s.fit.centroid;
  const Piece axis{link.a, link.b};
  result.fraction = axis.nearest(result.at);
  result.on_axis = axis.at(result.fraction);
  result.distance = length(result.at - result.on_axis);
  if (result.distance > 0)
    result.away = (result.on_axis - result.at) / result.distance;
  else
    result.away = s.fit.normal;
  return result;
}

/// For a link that is a ball: the same result as for its centre.
std::optional<View::LinkNearest> nearest_to_ball(const Segment& s, const Vector3d& centre, double limit,
                                                 double rounding) {
  const auto found = nearest_of(s, centre, limit, rounding);
  if (!found) return std::nullopt;
  View::LinkNearest result;
  result.at = found->at, result.on_axis = centre;
  result.distance = found->distance, result.edge = found->edge;
  if ((found->edge || !s.polygon) && found->distance > 0) {
    result.away = (centre - found->at) / found->distance;
  } else if (s.polygon) {
    const geometry::Plane plane = s.polygon->plane();
    result.away = plane.height_of(centre) < 0 ? Vector3d(-plane.normal) : plane.normal;
  } else {
    result.away = s.fit.normal;
  }
  return result;
}

}  // namespace

std::optional<View::LinkNearest> nearest_of(const Segment& s, const Capsule& link, double limit,
                                            double rounding) {
  std::optional<View::LinkNearest> result;
  if (link.a == link.b)
    result = nearest_to_ball(s, link.a, limit, rounding);
  else if (s.polygon)
    result = nearest_on(*s.polygon, link, limit, rounding);
  else
    result = nearest_on_point(s, link);
  if (!result) return result;
  result->segment = s.id;
  if (result->distance > limit) result.reset();
  return result;
}

}  // namespace limpet::model::internal
