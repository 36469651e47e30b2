// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <vector>

#include "common_line_internal.hpp"
#include "complex_internal.hpp"

namespace limpet::model::internal {

/// A perimeter point near a common line.
struct Station {
  double place = 0;   ///< of its foot on the line, scan's unit
  double offset = 0;  ///< in the polygon's plane from the line, scan's unit; the sign tells the side
  geometry::Point2 at;
  geometry::Slot vertex = geometry::kNoSlot;  ///< none: a point on the edge before or behind it
};

/// A stretch of perimeter that lies within reach of a common line and on which the only shared edges are
/// those of the two segments (thesis §2.6): stations one after the other, and the edges from each to the
/// next.
struct LineChain {
  std::vector<Station> stations;
  std::vector<geometry::Slot> edges;  ///< one less than the stations
};

/// A polygon's vertices as they lie along a common line. The same vertex gives the same numbers every time.
class LineView {
 public:
  LineView(const Setting& setting, const PolygonPart& part, const CommonLine& line)
      : perimeter_(part.perimeter),
        place_(affine(setting, part, line, line.along)),
        offset_(affine(setting, part, line, part.plane().normal.cross(line.along))) {}

  Station station(geometry::Slot s) const {
    const geometry::Point2 p = perimeter_.at(s);
    return {place_(p), offset_(p), p, s};
  }

 private:
  /// A coordinate along a direction from the line's origin, as a function of the chart point.
  struct Affine {
    double c0, cx, cy;
    double operator()(geometry::Point2 p) const { return c0 + cx * p.x + cy * p.y; }
  };
  static Affine affine(const Setting& setting, const PolygonPart& part, const CommonLine& line,
                       const Eigen::Vector3d& direction) {
    const geometry::Chart& chart = part.chart;
    return {direction.dot(chart.at({0, 0}, part.published.h0) - line.origin),
            setting.step * direction.dot(chart.u() + part.published.hx * chart.normal()),
            setting.step * direction.dot(chart.v() + part.published.hy * chart.normal())};
  }

  const geometry::Polygon& perimeter_;
  Affine place_, offset_;
};

/// A piece of a line: from one place to another.
struct LineWindow {
  double begin = 0, end = 0;
};

/// Takes the line's part inside a box out of a window; whether anything is left.
bool clip(LineWindow&, const CommonLine&, const Box3&);

/// The line where the planes of two polygons meet, and the stretch of it on which both can be near it.
/// Nothing when the normals differ by less than μ, or there is no such stretch.
struct LineBetween {
  CommonLine line;
  LineWindow window;
};
std::optional<LineBetween> line_between(const Setting&, const PolygonPart& a, const PolygonPart& b);

/// All chains of `a` along its line with `b` that come into the window, in its perimeter's direction.
std::vector<LineChain> line_chains(const Complex&, const Segment& a, const Segment& b, const CommonLine&,
                                   const LineWindow&, const SharingReach&);

/// Convex or concave, where `a` comes first in the line's n₁ × n₂ (thesis §2.6.1).
enum class Concavity { undecided, convex, concave };

/// That of neighbours is the one of any edge they share; else it is decided by the edges that lie opposite to
/// each other along the line.
Concavity concavity_of(const Complex&, const Segment& a, const Segment& b, const CommonLine&,
                       const std::vector<LineChain>& chains_a, const std::vector<LineChain>& chains_b);

}  // namespace limpet::model::internal
