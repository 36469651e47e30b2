// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <algorithm>
#include <cmath>

#include "complex_internal.hpp"

/// Geometry in space for the questions of view.hpp.
namespace limpet::model::internal {

/// Length of a vector, without intermediate over- or underflow.
inline double length(const Eigen::Vector3d& v) {
  const auto root = [](double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); };
  const double largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  if (largest > 0x1p-400 && largest < 0x1p500) return root(v[0], v[1], v[2]);
  const double scale = largest >= 0x1p500 ? 0x1p600 : 0x1p-600;
  return scale * root(v[0] / scale, v[1] / scale, v[2] / scale);
}

/// The gap between two boxes along each axis; 0 where they overlap.
inline Eigen::Vector3d gap_between(const Box3& a, const Box3& b) {
  return (b.min() - a.max()).cwiseMax(a.min() - b.max()).cwiseMax(0.0);
}

inline Box3 grown(const Box3& box, double by) {
  return {box.min() - Eigen::Vector3d::Constant(by), box.max() + Eigen::Vector3d::Constant(by)};
}

/// A box around a segment; by rounding, a vertex may lie outside it by up to a grid step.
inline Box3 tight_box(const Segment& s) { return s.polygon ? s.polygon->box : Box3(s.fit.centroid); }

/// An upper bound on the rounding errors of coordinates in a question about `around`, scan's unit: a grid
/// step for places in the model (2^48 steps at most), and more for places farther away. It is the margin with
/// which bounds rule out segments.
inline double rounding_near(const Complex& complex, const Box3& around) {
  return complex.setting().step +
         0x1p-48 * std::max(around.min().cwiseAbs().maxCoeff(), around.max().cwiseAbs().maxCoeff());
}

/// How much boxes are enlarged before segments are ruled out by them.
inline double room_around(const Complex& complex, double rounding) {
  return complex.setting().least.lambda / 64 + rounding;
}

/// A polygon in the frame of its chart: coordinates x, y, z along u, v and the chart's normal, in grid steps.
/// In this frame the polygon is its perimeter, in (x, y), lifted to the published plane z = h(x, y).
class Lifted {
 public:
  explicit Lifted(const PolygonPart& part)
      : part_(part), length_(std::sqrt(1 + part.published.squared_tilt())) {}

  const geometry::Polygon& perimeter() const { return part_.perimeter; }
  /// Unit normal of the plane, in the world.
  Eigen::Vector3d normal() const { return part_.plane().normal; }

  Eigen::Vector3d direction(const Eigen::Vector3d& world) const {
    const geometry::Chart& c = part_.chart;
    return Eigen::Vector3d(world.dot(c.u()), world.dot(c.v()), world.dot(c.normal())) / c.step();
  }
  Eigen::Vector3d place(const Eigen::Vector3d& world) const {
    return direction(world - part_.chart.origin());
  }

  /// Height of p above the plane, along the chart's normal.
  double rise(const Eigen::Vector3d& p) const { return p.z() - part_.published({p.x(), p.y()}); }
  /// By how much the rise grows along a direction.
  double climb(const Eigen::Vector3d& d) const {
    return d.z() - (part_.published.hx * d.x() + part_.published.hy * d.y());
  }
  /// Signed distance from the plane, positive outside, of a point with this rise.
  double height(double rise) const { return rise / length_; }
  /// The foot of the perpendicular from p on the plane, as a chart point.
  geometry::Point2 foot(const Eigen::Vector3d& p, double rise) const {
    const double t = rise / (length_ * length_);
    return {p.x() + t * part_.published.hx, p.y() + t * part_.published.hy};
  }
  /// The point of the plane over a chart point.
  Eigen::Vector3d lifted(geometry::Point2 p) const { return {p.x, p.y, part_.published(p)}; }
  /// The same in the world.
  Eigen::Vector3d world(geometry::Point2 p) const { return part_.chart.at(p, part_.published(p)); }
  /// Inner product of two chart displacements lifted to the plane.
  double product(geometry::Point2 a, geometry::Point2 b) const {
    const geometry::Lift& lift = part_.published;
    return dot(a, b) + (lift.hx * a.x + lift.hy * a.y) * (lift.hx * b.x + lift.hy * b.y);
  }
  bool inside(geometry::Point2 p) const {
    return part_.perimeter.locate(p) == geometry::Polygon::Side::inside;
  }

 private:
  const PolygonPart& part_;
  double length_;
};

/// An upper bound, with `slack` to spare, on the distance from its foot at which a plane or line is still
/// within `limit` of a point `height` above it. All lengths in one unit.
inline double reach_on_plane(double limit, double height, double slack) {
  const double h = std::abs(height);
  return std::sqrt(std::max(0.0, limit - h + slack) * (limit + h + slack)) + slack;
}

/// Visits the edges of a perimeter from a chart box outwards. look(slot) returns the distance up to which
/// edges are still of interest, at most `within`. Stops when all edges up to that distance, plus `slack`,
/// have been visited, some of them more than once. Distances are in the chart, in grid steps; on the lifted
/// plane they can only be larger.
template <class Look>
void look_at_edges_near(const geometry::Polygon& perimeter, const geometry::Box2& from, double within,
                        double slack, Look&& look) {
  const geometry::Box2& box = perimeter.box();
  const double gap_x = std::max({0.0, box.low.x - from.high.x, from.low.x - box.high.x});
  const double gap_y = std::max({0.0, box.low.y - from.high.y, from.low.y - box.high.y});
  const double gap = std::sqrt(gap_x * gap_x + gap_y * gap_y);
  const double width = box.high.x - box.low.x, height = box.high.y - box.low.y;
  // About as wide as a cell of the perimeter's edge index; a perimeter without an index is visited whole at
  // once.
  constexpr std::size_t kFew = geometry::EdgeIndex::kMinimum;
  const auto edges = static_cast<double>(std::max(perimeter.edge_count(), kFew));
  const bool indexed = perimeter.edge_count() >= kFew || perimeter.slot_count() > 2 * kFew;
  double span = within;
  if (indexed) span = std::max(std::sqrt(width * height / edges), (width + height) / (4 * edges));
  for (;;) {
    const double reach = std::min(within, gap + span);
    if (gap > reach + slack) return;
    // The box that holds the part of the perimeter's box within that distance.
    const double x = reach_on_plane(reach, gap_y, slack), y = reach_on_plane(reach, gap_x, slack);
    perimeter.any_edge_near({{from.low.x - x, from.low.y - y}, {from.high.x + x, from.high.y + y}},
                            [&](geometry::Slot s) {
                              within = std::min(within, look(s));
                              return false;
                            });
    if (reach >= within || span > width + height) return;
    span *= 3;
  }
}

}  // namespace limpet::model::internal
