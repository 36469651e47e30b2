// Copyright the limpet authors. GPL-3.0-or-later.
#include <cmath>
#include <limpet/audit/laws_internal.hpp>

namespace limpet::audit::internal {
namespace {

// All in grid steps. Readings farther out are no points; what is made of points lies among them, or nearly.
constexpr double kPointLimit = 0x1p48;
constexpr double kPlaceLimit = 0x1p49;
constexpr double kChartLimit = 0x1p40;

bool is_within(const Vector& a, double limit) {
  return std::abs(a[0]) <= limit && std::abs(a[1]) <= limit && std::abs(a[2]) <= limit;
}

bool is_whole(double x) { return x == std::trunc(x); }

void judge_mean(const Segment& segment, Report& report) {
  if (segment.moments.m == 0) return;  // sums of no points are judged by the law "moments"
  const Int128 limit = static_cast<Int128>(segment.moments.m) * static_cast<Int128>(kPointLimit);
  for (const Int128 sum : segment.moments.sum)
    if (sum > limit || sum < -limit) {
      report.add("grid", segment_name(segment), "its points' mean is beyond 2^48 steps");
      return;
    }
}

}  // namespace

void judge_points_on_grid(const Segment& segment, Report& report) {
  judge_mean(segment, report);
  for (const RawPoint& point : segment.raw) {
    const Vector& at = point.position;
    if (is_within(at, kPointLimit) && is_whole(at[0]) && is_whole(at[1]) && is_whole(at[2])) continue;
    report.add("grid", segment_name(segment), "a raw point is no grid point within 2^48 steps");
    return;
  }
}

void judge_chart_on_grid(const Polygon& polygon, double step, Report& report) {
  const double limit = kPlaceLimit * step;
  if (!is_within(polygon.origin, limit) || !is_within(polygon.initial_centroid, limit) ||
      std::abs(polygon.h0) > kPlaceLimit)
    report.add("grid", segment_name(polygon), "its plane is beyond 2^49 steps");
}

void judge_vertices_on_grid(const Polygon& polygon, bool rounded, Report& report) {
  const auto is_on_grid = [rounded](double x) {
    return rounded ? is_whole(x) && std::abs(x) <= kChartLimit : std::abs(x) <= kPlaceLimit;
  };
  for (std::size_t c = 0; c < polygon.cycles.size(); ++c)
    for (std::size_t i = 0; i < polygon.cycles[c].size(); ++i) {
      const Vertex& vertex = polygon.cycles[c][i];
      if (is_on_grid(vertex.x) && is_on_grid(vertex.y)) continue;
      report.add("grid", vertex_name(polygon, c, i),
                 rounded ? "not a grid point within 2^40 steps" : "beyond 2^49 steps");
    }
}

}  // namespace limpet::audit::internal
