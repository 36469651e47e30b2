// Copyright the limpet authors. GPL-3.0-or-later.
//
// A surface may lie off its plane by the tolerance, but only gradually: added points must continue the
// surface that is there already, within the noise. So a table top that bends is one polygon, but does not
// take in the points of a step beside it.
#include <algorithm>
#include <cmath>

#include "heights_internal.hpp"
#include "thresholds_internal.hpp"

namespace limpet::model::internal {
namespace {

/// Of squares on this chart, in grid steps.
double side_of(const Setting& setting, const geometry::Chart& chart) {
  return 2 * setting.scale_at(chart.origin()).gap;
}

std::uint64_t key(double side, geometry::Point2 p, int dx = 0, int dy = 0) {
  const auto column = static_cast<std::int32_t>(std::floor(p.x / side)) + dx;
  const auto row = static_cast<std::int32_t>(std::floor(p.y / side)) + dy;
  return std::uint64_t{static_cast<std::uint32_t>(column)} << 32 | static_cast<std::uint32_t>(row);
}

HeightMap::Sum seen_from(const geometry::Chart& chart, const Eigen::Vector3d& p, double count) {
  const geometry::Point2 at = chart.project(p);
  const double height = chart.normal().dot(p - chart.origin()) / chart.step();
  return {count, count * at.x, count * at.y, count * height};
}

/// The segment's points in the world, with counts: one by one if it keeps them, else the means of its height
/// map's squares.
std::vector<std::pair<Eigen::Vector3d, double>> samples(const Setting& setting, const Segment& s) {
  std::vector<std::pair<Eigen::Vector3d, double>> result;
  for (const RawPoint& raw : s.data.raw()) result.emplace_back(setting.world(raw.at), 1);
  if (!result.empty()) return result;
  for (const HeightMap::Sum& sum : s.polygon->heights.squares())
    result.emplace_back(s.polygon->chart.at(sum.mean(), sum.mean_height()), sum.count);
  return result;
}

}  // namespace

void HeightMap::add(double side, const Sum& sum) { squares_[key(side, sum.mean())].add(sum); }

HeightMap::Sum HeightMap::around(double side, geometry::Point2 p) const {
  const auto own = squares_.find(key(side, p));
  if (own != squares_.end() && own->second.count >= kFewInSquare) return own->second;
  Sum all;
  for (int dx = -1; dx <= 1; ++dx)
    for (int dy = -1; dy <= 1; ++dy)
      if (const auto found = squares_.find(key(side, p, dx, dy)); found != squares_.end())
        all.add(found->second);
  return all;
}

std::vector<std::pair<std::uint64_t, HeightMap::Sum>> HeightMap::keyed_squares() const {
  std::vector<std::pair<std::uint64_t, Sum>> sorted(squares_.begin(), squares_.end());
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return sorted;
}

std::vector<HeightMap::Sum> HeightMap::squares() const {
  std::vector<Sum> result;
  for (const auto& [place, sum] : keyed_squares()) result.push_back(sum);
  return result;
}

void add_height(const Setting& setting, PolygonPart& part, const Eigen::Vector3d& p, double count) {
  if (setting.relief_kept()) part.heights.add(side_of(setting, part.chart), seen_from(part.chart, p, count));
}

void add_heights(const Setting& setting, PolygonPart& part, const Segment& other) {
  if (!setting.relief_kept()) return;
  if (!other.polygon && !other.young())
    return add_height(setting, part, other.fit.centroid, static_cast<double>(other.count()));
  if (!other.polygon) {
    for (const RawPoint& raw : other.data.raw()) add_height(setting, part, setting.world(raw.at), 1);
    return;
  }
  for (const auto& [p, count] : samples(setting, other)) add_height(setting, part, p, count);
}

void rechart_heights(const Setting& setting, PolygonPart& part, const geometry::Chart& from) {
  HeightMap map;
  for (const HeightMap::Sum& sum : part.heights.squares())
    map.add(side_of(setting, part.chart),
            seen_from(part.chart, from.at(sum.mean(), sum.mean_height()), sum.count));
  part.heights = std::move(map);
}

std::optional<LocalResidual> local_residual(const Setting& setting, const Segment& polygon,
                                            const Eigen::Vector3d& p) {
  const PolygonPart& part = *polygon.polygon;
  const geometry::Point2 at = part.chart.project(p);
  const double side = side_of(setting, part.chart);
  const HeightMap::Sum near = part.heights.around(side, at);
  if (near.count == 0) return std::nullopt;
  const geometry::Plane plane = polygon.fit.plane();
  const double height = plane.height_of(p) - plane.height_of(part.chart.at(near.mean(), near.mean_height()));
  const double way2 = geometry::squared_length(near.mean() - at) / (side * side / 4);
  const double tolerance2 = setting.parameters.tolerance * setting.parameters.tolerance;
  return LocalResidual{height, polygon.data.variance() / near.count,
                       tolerance2 * (kBend * kBend * way2 + kKnown * kKnown)};
}

bool surfaces_continue(const Setting& setting, const Segment& large, const Segment& small) {
  double count = 0, squares = 0, limit = 0;
  for (const auto& [p, m] : samples(setting, small)) {
    const auto local = local_residual(setting, large, p);
    if (!local) continue;
    count += m;
    squares += m * local->height * local->height;
    limit += m * (9 * local->variance + local->bend2 + (small.young() ? 9 : 4) * small.data.variance());
  }
  return count > 0 && squares <= limit;
}

}  // namespace limpet::model::internal
