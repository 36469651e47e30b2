// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <vector>

#include "common_line_internal.hpp"
#include "complex_internal.hpp"

namespace limpet::model::internal {

/// A point of a perimeter near the common line of two segments.
struct Station {
  double place = 0;   ///< coordinate of its foot along the line, scan's unit
  double offset = 0;  ///< signed distance from the line in the polygon's plane, scan's unit
  geometry::Point2 at;
  geometry::Slot vertex = geometry::kNoSlot;  ///< none: a point inside the adjacent edge of the chain
};

/// A stretch of a perimeter within reach of the common line of two segments, with no shared edges except
/// those between the two (thesis §2.6): its successive stations, and the edges from each to the next.
struct LineChain {
  std::vector<Station> stations;
  std::vector<geometry::Slot> edges;  ///< one fewer than the stations
};

/// The vertices of a polygon in coordinates of a common line. The same vertex always gives the same numbers,
/// to the bit.
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
  /// The coordinate along a direction, from the line's origin, as an affine function of the chart point.
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

/// A piece of a line, between two coordinates along it.
struct LineWindow {
  double begin = 0, end = 0;
};

/// Restricts a window to the part of the line inside a box. Returns whether anything is left.
bool clip(LineWindow&, const CommonLine&, const Box3&);

/// The line where the planes of two polygons meet, and the window in which it is as near to the boxes of both
/// as a section may be to it (SharingReach::at_angle()). Nothing when the normals differ by less than
/// SharingReach::most_cosine() allows, or there is no such window.
struct LineBetween {
  CommonLine line;
  LineWindow window;
};
std::optional<LineBetween> line_between(const Setting&, const PolygonPart& a, const PolygonPart& b,
                                        const SharingReach& = {});

/// All chains of `a` along its line with `b` that reach into the window, each in the direction of the
/// perimeter of `a`.
std::vector<LineChain> line_chains(const Complex&, const Segment& a, const Segment& b, const CommonLine&,
                                   const LineWindow&, const SharingReach&);

/// The concavity of two segments (thesis §2.6.1).
enum class Concavity { undecided, convex, concave };

/// The concavity of neighbours follows from any edge they share; else, from the edges of their chains that
/// lie opposite each other along the line. Precondition: the line is along n₁ × n₂, with n₁ the normal of
/// `a`.
Concavity concavity_of(const Complex&, const Segment& a, const Segment& b, const CommonLine&,
                       const std::vector<LineChain>& chains_a, const std::vector<LineChain>& chains_b);

}  // namespace limpet::model::internal
