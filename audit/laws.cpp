// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <cmath>
#include <limits>
#include <limpet/audit/laws.hpp>
#include <limpet/audit/laws_internal.hpp>

namespace limpet::audit {

const std::vector<Law>& laws() {
  static const std::vector<Law> all = {
      {"finite", "every number is finite"},
      {"parameters",
       "1e-150 < resolution < 1e150, 0 < angle < pi/2, noise and tolerance >= 0, the grid step a power of "
       "two, "
       "at most the resolution and at least 2^-20 of it"},
      {"segment-identity", "segment identities are nonzero, unique, and below the next one"},
      {"edge-identity", "edge identities are nonzero, unique over the model, and below the next one"},
      {"segment-count", "the header counts as many segments of each kind as there are"},
      {"point-count",
       "points processed = the sum of m over all segments + points confirmed + points expired"},
      {"confirmed", "points confirm only polygons without data"},
      {"moments", "m >= 1 (polygons: or no data at all), and the covariance is positive semidefinite"},
      {"raw", "raw points are none or all m, and then sum to the moments exactly"},
      {"axes", "raw sensing axes are unit vectors that sum to the segment's; no sum is longer than m"},
      {"point-variance", "the sensor points of a point segment have variance below resolution^2"},
      {"plane-variance", "the sensor points of a polygon have variance below resolution^2 about its plane"},
      {"chart",
       "the chart axes u, v, n are orthonormal and right-handed, the initial normal is a unit vector"},
      {"tilt", "the published plane is within 3 degrees of the chart"},
      {"outward", "the plane's normal faces against the sum of the sensing axes"},
      {"grid",
       "sensor points are whole and within 2^48 steps of the origin, planes within 2^49; unless arithmetic "
       "is "
       "float, chart coordinates are whole and at most 2^40"},
      {"cycle-size", "a polygon has an outer cycle, and every cycle at least three vertices"},
      {"edge-length", "no edge has zero length"},
      {"simple", "edges of one segment meet only where consecutive ones join"},
      {"direction", "the outer cycle runs anticlockwise, holes clockwise"},
      {"nesting", "holes lie inside the outer cycle and outside each other"},
      {"partner", "a shared edge has exactly one partner, mutual, on another segment"},
      {"shared-line", "both copies end within 2 grid steps / sin(theta) of the planes' common line"},
      {"shared-direction", "the copies of a shared edge run in opposite directions along the common line"},
      {"shared-overlap", "the copies of a shared edge overlap along the common line"},
      {"shared-ends",
       "the copies' ends coincide to 4 grid steps / sin(theta), unless one is a corner vertex"},
      {"concavity", "a pair of neighbours has one concavity"},
      {"local-order", "edges shared by two cycles come on the one in the reverse order of the other"},
      {"global-order", "no two neighbours' edges alternate on a cycle"},
  };
  return all;
}

namespace {

/// The resolution where a segment's sensor points have their mean, rounded up by more than computing it
/// takes.
double resolution_at(const Document& document, const Moments& moments) {
  if (!(document.widening > 0) || moments.m == 0) return document.resolution;
  double least2 = std::numeric_limits<double>::infinity();
  for (const Vector& sensor : document.sensors) {
    double distance2 = 0;
    for (int i = 0; i < 3; ++i) {
      const double mean =
          static_cast<double>(moments.sum[i]) / static_cast<double>(moments.m) * document.step;
      distance2 += (mean - sensor[i]) * (mean - sensor[i]);
    }
    least2 = std::min(least2, distance2);
  }
  // A widening from nowhere, or without end, is a law of its own.
  const double resolution = (document.resolution + document.widening * std::sqrt(least2)) * (1 + 1e-12);
  return std::isfinite(resolution) ? resolution : document.resolution;
}

}  // namespace

std::vector<Violation> judge(const Document& document) {
  using namespace internal;
  Report report;
  judge_finite(document, report);
  judge_parameters(document, report);
  judge_identities(document, report);
  judge_counts(document, report);
  const double step = document.step;
  const bool has_scale = std::isfinite(step) && step > 0 && std::isfinite(document.resolution) &&
                         document.resolution > 0 && std::isfinite(document.widening);
  for (const Segment& segment : document.point_segments) {
    if (!is_finite(segment)) continue;
    judge_data(segment, report);
    if (segment.moments.m == 0) report.add("moments", segment_name(segment), "a point segment has no data");
    judge_points_on_grid(segment, report);
    if (has_scale) judge_point(segment, step, resolution_at(document, segment.moments), report);
  }
  for (const Polygon& polygon : document.polygons) {
    if (!is_finite(polygon)) continue;
    judge_data(polygon, report);
    if (has_scale) judge_plane(polygon, step, resolution_at(document, polygon.moments), report);
    judge_points_on_grid(polygon, report);
    if (has_scale) judge_chart_on_grid(polygon, step, report);
    judge_vertices_on_grid(polygon, document.arithmetic != Arithmetic::kFloat, report);
    judge_perimeter(polygon, report);
  }
  judge_shared_edges(document, report);
  return report.take();
}

}  // namespace limpet::audit
