// Copyright the limpet authors. GPL-3.0-or-later.
#include <cmath>
#include <initializer_list>
#include <limpet/audit/laws_internal.hpp>
#include <unordered_set>

namespace limpet::audit::internal {
namespace {

bool are_finite(std::initializer_list<double> numbers) {
  for (const double x : numbers)
    if (!std::isfinite(x)) return false;
  return true;
}

bool are_finite(const Vector& a) { return are_finite({a[0], a[1], a[2]}); }

void judge_identity(const char* law, std::uint64_t id, std::uint64_t next, const std::string& where,
                    std::unordered_set<std::uint64_t>& seen, Report& report) {
  const std::string name = "identity " + std::to_string(id);
  if (id == 0) {
    report.add(law, where, "identity 0");
    return;
  }
  if (id >= next) report.add(law, where, name + " is not below the next one, " + std::to_string(next));
  if (!seen.insert(id).second) report.add(law, where, name + " is used twice");
}

}  // namespace

bool is_finite(const Segment& segment) {
  if (!are_finite(segment.axis_sum)) return false;
  for (const RawPoint& point : segment.raw)
    if (!are_finite(point.position) || !are_finite(point.axis)) return false;
  return true;
}

bool is_finite(const Polygon& polygon) {
  if (!is_finite(static_cast<const Segment&>(polygon))) return false;
  for (const Vector* a : {&polygon.origin, &polygon.u, &polygon.v, &polygon.n, &polygon.initial_centroid,
                          &polygon.initial_normal})
    if (!are_finite(*a)) return false;
  if (!are_finite({polygon.h0, polygon.hx, polygon.hy})) return false;
  for (const Cycle& cycle : polygon.cycles)
    for (const Vertex& vertex : cycle)
      if (!are_finite({vertex.x, vertex.y})) return false;
  return true;
}

void judge_finite(const Document& document, Report& report) {
  const char* law = "finite";
  const char* what = "a number is not finite";
  if (!are_finite({document.resolution, document.widening, document.angle, document.noise, document.tolerance,
                   document.step, document.growth, document.growth2, document.quantum,
                   document.redundancy_count, document.redundancy_ratio}))
    report.add(law, "header", what);
  for (const Vector& sensor : document.sensors)
    if (!are_finite(sensor)) report.add(law, "header", what);
  for (const Segment& segment : document.point_segments)
    if (!is_finite(segment)) report.add(law, segment_name(segment), what);
  for (const Polygon& polygon : document.polygons)
    if (!is_finite(polygon)) report.add(law, segment_name(polygon), what);
}

void judge_parameters(const Document& document, Report& report) {
  // Numbers that are not finite are reported by the law "finite"; the comparisons below are false for NaN.
  const auto demand_not = [&report](bool broken, const char* what) {
    if (broken) report.add("parameters", "header", what);
  };
  demand_not(document.resolution <= 0, "resolution is not above 0");
  demand_not(document.resolution > 0 && (document.resolution <= 1e-150 || document.resolution >= 1e150),
             "resolution is out of range");
  demand_not(document.widening < 0 || document.widening > 0.25,
             "the resolution grows by no 0 to 0.25 per range");
  demand_not(document.widening > 0 && document.sensors.empty(), "the resolution grows from nowhere");
  demand_not(document.angle <= 0 || document.angle >= std::acos(0.0), "angle is not in (0, pi/2)");
  demand_not(document.noise < 0, "noise is below 0");
  demand_not(document.tolerance < 0, "tolerance is below 0");
  demand_not(document.growth < 0 || document.growth2 < 0, "the noise shrinks with the range");
  demand_not(document.quantum < 0, "the input quantum is below 0");
  demand_not(document.neighbours > 1, "neighbours are formed (1) or not (0)");
  demand_not(document.redundancy_count < 0 || document.redundancy_ratio < 0, "psi or phi is below 0");
  int exponent = 0;
  demand_not(std::isfinite(document.step) && std::frexp(document.step, &exponent) != 0.5,
             "the grid step is not a power of two");
  demand_not(document.step > 0 && document.resolution > 0 &&
                 (document.step > document.resolution || document.step < 0x1p-20 * document.resolution),
             "the grid step is not at most the resolution and at least 2^-20 of it");
}

void judge_identities(const Document& document, Report& report) {
  std::unordered_set<std::uint64_t> segments, edges;
  for (const Segment& segment : document.point_segments)
    judge_identity("segment-identity", segment.id, document.next_segment, segment_name(segment), segments,
                   report);
  for (const Polygon& polygon : document.polygons) {
    judge_identity("segment-identity", polygon.id, document.next_segment, segment_name(polygon), segments,
                   report);
    for (std::size_t c = 0; c < polygon.cycles.size(); ++c)
      for (std::size_t i = 0; i < polygon.cycles[c].size(); ++i)
        judge_identity("edge-identity", polygon.cycles[c][i].edge, document.next_edge,
                       vertex_name(polygon, c, i), edges, report);
  }
}

void judge_counts(const Document& document, Report& report) {
  const auto compare = [&report](std::uint64_t declared, std::size_t found, const std::string& kind) {
    if (declared != found)
      report.add("segment-count", "header",
                 std::to_string(declared) + " " + kind + " segments declared, " + std::to_string(found) +
                     " present");
  };
  compare(document.declared_points, document.point_segments.size(), "point");
  compare(document.declared_polygons, document.polygons.size(), "polygon");

  // In 128 bits the sum cannot overflow, however many segments the file holds.
  Int128 represented = document.expired;
  for (const Segment& segment : document.point_segments) represented += segment.moments.m;
  for (const Polygon& polygon : document.polygons) {
    represented += polygon.moments.m;
    represented += polygon.confirmed;
    if (polygon.confirmed > 0 && polygon.moments.m > 0)
      report.add("confirmed", segment_name(polygon),
                 std::to_string(polygon.confirmed) + " points confirm it, but it has data of its own");
  }
  if (represented != static_cast<Int128>(document.points))
    report.add("point-count", "header",
               std::to_string(document.points) + " points, but segments, confirmed and expired points make " +
                   (represented > static_cast<Int128>(UINT64_MAX)
                        ? "more than 2^64"
                        : std::to_string(static_cast<std::uint64_t>(represented))));
}

}  // namespace limpet::audit::internal
