// Copyright the limpet authors. GPL-3.0-or-later.
#include "divided_data_internal.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <limpet/geometry/predicates.hpp>

#include "thresholds_internal.hpp"

namespace limpet::model::internal {
namespace {

using geometry::Point2;

/// Centre and second moments about it of an area, per unit of it, in grid steps.
struct AreaMoments {
  Point2 centre{};
  double xx = 0, xy = 0, yy = 0;
};

/// Summed over the triangles from one vertex to each edge.
AreaMoments moments_of(const geometry::Polygon& polygon) {
  const Point2 origin = polygon.at(polygon.outer().first);
  double area = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  for_each_edge(polygon, [&](geometry::Slot s) {
    const Point2 p = polygon.at(s) - origin, q = polygon.end(s) - origin;
    const double twice = cross(p, q);
    area += twice / 2;
    x += twice * (p.x + q.x) / 6, y += twice * (p.y + q.y) / 6;
    xx += twice * (p.x * p.x + p.x * q.x + q.x * q.x) / 12;
    yy += twice * (p.y * p.y + p.y * q.y + q.y * q.y) / 12;
    xy += twice * (2 * p.x * p.y + p.x * q.y + q.x * p.y + 2 * q.x * q.y) / 24;
  });
  const double cx = x / area, cy = y / area;
  return {origin + Point2{cx, cy}, xx / area - cx * cx, xy / area - cx * cy, yy / area - cy * cy};
}

/// The sums over `count` points of this mean and covariance (grid steps), rounded.
Moments moments_with(std::int64_t count, const Eigen::Vector3d& mean, const Eigen::Matrix3d& covariance) {
  MomentsRecord record;
  record.count = count;
  std::array<Int128, 3> centre{}, rest{};
  Eigen::Vector3d off;
  for (int i = 0; i < 3; ++i) {
    const double whole = std::floor(mean[i] + 0.5);
    off[i] = mean[i] - whole;
    const auto at = static_cast<std::size_t>(i);
    centre[at] = static_cast<std::int64_t>(whole);
    rest[at] = static_cast<std::int64_t>(std::floor(static_cast<double>(count) * off[i] + 0.5));
    record.sum[at] = count * centre[at] + rest[at];
  }
  std::size_t k = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j, ++k) {
      const auto a = static_cast<int>(i), b = static_cast<int>(j);
      const double central = static_cast<double>(count) * (covariance(a, b) + off[a] * off[b]);
      record.product[k] = count * centre[i] * centre[j] + centre[i] * rest[j] + centre[j] * rest[i] +
                          static_cast<std::int64_t>(std::floor(central + 0.5));
    }
  return Moments(record);
}

Portion portion_of(const Setting& setting, const Segment& s, const geometry::Polygon& perimeter,
                   std::int64_t count) {
  const PolygonPart& part = *s.polygon;
  const AreaMoments area = moments_of(perimeter);
  const auto on_plane = [&](Point2 p) {
    const Eigen::Vector3d at = part.at(p);
    return Eigen::Vector3d(at - s.fit.height_of(at) * s.fit.normal);
  };
  constexpr double kFar = 4096;  // grid steps, so that differences keep their digits
  const Eigen::Vector3d mean = on_plane(area.centre),
                        x = (on_plane(area.centre + Point2{kFar, 0}) - mean) / (kFar * setting.step),
                        y = (on_plane(area.centre + Point2{0, kFar}) - mean) / (kFar * setting.step);
  // A reading is rounded to the grid, so no covariance is without that; it keeps the sums those of some
  // points.
  const Eigen::Matrix3d covariance =
      area.xx * x * x.transpose() + area.xy * (x * y.transpose() + y * x.transpose()) +
      area.yy * y * y.transpose() +
      s.fit.u3 / (setting.step * setting.step) * s.fit.normal * s.fit.normal.transpose() +
      Eigen::Matrix3d::Identity();
  const double fraction = static_cast<double>(count) / static_cast<double>(s.count());
  SegmentData::Sums sums = s.data.sums();
  sums.moments = moments_with(count, mean / setting.step, covariance);
  sums.axis *= fraction, sums.variance *= fraction, sums.since *= fraction;
  Portion portion{SegmentData(sums, s.data.last_joined()), {}, {}};
  portion.fit = fit_to(portion.data.moments(), setting.step, portion.data.axis_sum());
  std::vector<std::pair<std::uint64_t, HeightMap::Sum>> squares = part.heights.keyed_squares();
  std::erase_if(squares, [&](const auto& square) {
    const Point2 at = geometry::round_to_grid(square.second.mean());
    return perimeter.locate(at) == geometry::Polygon::Side::outside;
  });
  portion.heights = HeightMap::of_squares(squares);
  return portion;
}

}  // namespace

std::optional<Portions> divided(const Setting& setting, const Segment& s, const geometry::Polygon& rest,
                                const geometry::Polygon& piece) {
  const double fraction = piece.area() / (piece.area() + rest.area());
  const auto count = static_cast<std::int64_t>(std::floor(static_cast<double>(s.count()) * fraction + 0.5));
  if (std::min(count, s.count() - count) < kFewestOfPart) return std::nullopt;
  return Portions{portion_of(setting, s, rest, s.count() - count), portion_of(setting, s, piece, count)};
}

}  // namespace limpet::model::internal
