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

Felt::Felt(const geometry::Chart& chart, const geometry::Polygon& perimeter, std::int64_t points)
    : points_(points), area_(area_felt(chart, perimeter, points)) {
  parts_.push_back({chart, perimeter});
}

void Felt::add(Felt&& other) {
  parts_.insert(parts_.end(), std::make_move_iterator(other.parts_.begin()),
                std::make_move_iterator(other.parts_.end()));
  readings_.insert(readings_.end(), other.readings_.begin(), other.readings_.end());
  points_ += other.points_;
  area_ += other.area_;
  added_to_ |= other.added_to_;
}

double Felt::distance(const Eigen::Vector3d& p, double within) const {
  for (const Part& part : parts_) within = distance_to(part.chart, part.perimeter, p, within);
  for (const Eigen::Vector3d& reading : readings_) within = std::min(within, (reading - p).norm());
  return within;
}

double Felt::density() const { return area_ > 0 ? static_cast<double>(points_) / area_ : 0; }

}  // namespace limpet::model::internal
