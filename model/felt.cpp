// Copyright the limpet authors. GPL-3.0-or-later.
#include "felt_internal.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <limpet/geometry/predicates.hpp>
#include <limpet/geometry/search.hpp>

namespace limpet::model::internal {
namespace {

double length_of_boundary(const geometry::Polygon& perimeter) {
  double length = 0;
  for (std::uint32_t i = 0; i < perimeter.slot_count(); ++i)
    if (const geometry::Slot s{i}; perimeter.alive(s))
      length += std::sqrt(geometry::squared_length(perimeter.end(s) - perimeter.at(s)));
  return length;
}

/// Is it the same part, down to its vertices?
bool same(const Felt::Part& a, const Felt::Part& b) {
  if (a.points != b.points || a.area != b.area || a.chart.origin() != b.chart.origin() ||
      a.chart.normal() != b.chart.normal() || a.perimeter.edge_count() != b.perimeter.edge_count())
    return false;
  const auto same_cycle = [](const auto& p, const auto& q) {
    return std::equal(
        p.begin(), p.end(), q.begin(), q.end(),
        [](const geometry::NewVertex& u, const geometry::NewVertex& v) { return u.at == v.at; });
  };
  const auto p = a.perimeter.boundary(), q = b.perimeter.boundary();
  return std::equal(p.begin(), p.end(), q.begin(), q.end(), same_cycle);
}

bool before_in_space(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

/// The mean over a polygon's area of the square of the least λ over λ, at the points of a lattice; at the
/// middle of its box where none is inside.
double mean_thinning(const Setting& setting, const geometry::Chart& chart,
                     const geometry::Polygon& perimeter) {
  if (!setting.resolution_grows()) return 1;
  constexpr int kAcross = 16;
  const geometry::Box2 box = perimeter.box();
  const auto thinning = [&](geometry::Point2 p) {
    return setting.least.lambda2 / setting.scale_at(chart.at(p, 0)).lambda2;
  };
  double sum = 0;
  int inside = 0;
  for (int i = 0; i < kAcross * kAcross; ++i) {
    const int column = i % kAcross, row = i / kAcross;
    const double x = (column + 0.5) / kAcross, y = (row + 0.5) / kAcross;
    const geometry::Point2 p = geometry::round_to_grid(
        {box.low.x + x * (box.high.x - box.low.x), box.low.y + y * (box.high.y - box.low.y)});
    if (perimeter.locate(p) == geometry::Polygon::Side::outside) continue;
    sum += thinning(p);
    ++inside;
  }
  return inside > 0 ? sum / inside : thinning(0.5 * (box.low + box.high));
}

}  // namespace

double distance_to(const geometry::Chart& chart, const geometry::Polygon& perimeter, const Eigen::Vector3d& p,
                   double within) {
  const double step = chart.step();
  const geometry::Point2 q = geometry::round_to_grid(chart.project(p));
  if (!perimeter.box().grown(within / step).contains(q)) return within;
  if (perimeter.locate(q) != geometry::Polygon::Side::outside) return 0;
  const auto nearest = geometry::nearest_perimeter_point(perimeter, q, within / step);
  return nearest ? std::sqrt(nearest->squared_distance) * step : within;
}

double area_felt(const geometry::Chart& chart, const geometry::Polygon& perimeter, std::int64_t points) {
  // A perimeter goes through the outermost readings; the surface goes on for half the space between two.
  const double area = std::max(perimeter.area(), 1.0), m = std::max(1.0, static_cast<double>(points));
  return (area + length_of_boundary(perimeter) * std::sqrt(area / m) / 2) * chart.step() * chart.step();
}

Felt::Felt(const Setting& setting, const geometry::Chart& chart, const geometry::Polygon& perimeter,
           std::int64_t points) {
  parts_.push_back({chart, perimeter, points, area_felt(chart, perimeter, points),
                    mean_thinning(setting, chart, perimeter)});
}

void Felt::add(Felt&& other) {
  const std::size_t before = parts_.size();
  for (Part& part : other.parts_)
    if (std::none_of(parts_.begin(), parts_.begin() + static_cast<std::ptrdiff_t>(before),
                     [&](const Part& own) { return same(own, part); }))
      parts_.push_back(std::move(part));
  const bool were_one = parts_.size() < before + other.parts_.size();
  readings_.insert(readings_.end(), other.readings_.begin(), other.readings_.end());
  if (were_one) {
    std::sort(readings_.begin(), readings_.end(), before_in_space);
    readings_.erase(std::unique(readings_.begin(), readings_.end()), readings_.end());
  }
  added_to_ |= other.added_to_;
}

double Felt::distance(const Eigen::Vector3d& p, double within) const {
  for (const Part& part : parts_) within = distance_to(part.chart, part.perimeter, p, within);
  for (const Eigen::Vector3d& reading : readings_) within = std::min(within, (reading - p).norm());
  return within;
}

double Felt::density(double thinning) const {
  double points = 0, area = 0, thinned = 0;
  for (const Part& p : parts_)
    points += static_cast<double>(p.points), area += p.area, thinned += p.area * p.thinning;
  return area > 0 ? points / area * (thinning / (thinned / area)) : 0;
}

}  // namespace limpet::model::internal
