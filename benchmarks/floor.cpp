// Copyright the limpet authors. GPL-3.0-or-later.
#include "floor.hpp"

#include <array>
#include <cmath>

#include <Eigen/Geometry>
#include <boost/iterator/function_output_iterator.hpp>
#include <limpet/geometry/predicates.hpp>

namespace limpet::benchmarks {

using Eigen::Vector3d;

namespace {

void add_to(model::MomentsRecord& moments, const std::array<std::int64_t, 3>& at) {
  const model::Int128 x = at[0], y = at[1], z = at[2];
  ++moments.count;
  moments.sum[0] += x, moments.sum[1] += y, moments.sum[2] += z;
  moments.product[0] += x * x, moments.product[1] += x * y, moments.product[2] += x * z;
  moments.product[3] += y * y, moments.product[4] += y * z, moments.product[5] += z * z;
}

}  // namespace

Floor::Floor(const model::ModelRecord& record)
    : resolution_(record.parameters.resolution), step_(record.grid_step) {
  geometry::EdgeIds ids;
  for (const auto& s : record.polygon_segments) {
    Frozen f;
    f.chart = geometry::Chart(s.chart_origin, s.chart_u, s.chart_v, s.chart_normal, step_);
    geometry::Lift lift;
    lift.h0 = s.height[0], lift.hx = s.height[1], lift.hy = s.height[2];
    f.plane = lift.plane(f.chart);
    Eigen::AlignedBox3d box;
    std::vector<std::vector<geometry::NewVertex>> cycles;
    for (const auto& cycle : s.cycles) {
      auto& vertices = cycles.emplace_back();
      for (const auto& v : cycle) {
        vertices.push_back({{v.x, v.y}});
        box.extend(f.chart.at({v.x, v.y}, lift({v.x, v.y})));
      }
    }
    f.polygon = geometry::Polygon::from_cycles(cycles, ids).value();
    const Vector3d low = box.min().array() - resolution_, high = box.max().array() + resolution_;
    index_.insert({{Corner(low.x(), low.y(), low.z()), Corner(high.x(), high.y(), high.z())},
                   static_cast<std::uint32_t>(frozen_.size())});
    frozen_.push_back(std::move(f));
  }
}

std::int64_t Floor::add(std::span<const model::SensorPoint> points) {
  std::int64_t inside = 0;
  for (const auto& p : points) inside += add(p);
  return inside;
}

bool Floor::add(const model::SensorPoint& reading) {
  const Vector3d& p = reading.position;
  Frozen* best = nullptr;
  double nearest = resolution_;
  const auto look_at = [&](const Entry& entry) {
    Frozen& f = frozen_[entry.second];
    const double height = std::abs(f.plane.height_of(p));
    if (height < nearest && reading.axis.dot(f.plane.normal) < 0) nearest = height, best = &f;
  };
  index_.query(boost::geometry::index::intersects(Corner(p.x(), p.y(), p.z())),
               boost::make_function_output_iterator(look_at));
  if (!best) return false;
  const auto q = geometry::round_to_grid(best->chart.project(p));
  const bool inside = best->polygon.locate(q) != geometry::Polygon::Side::outside;
  std::array<std::int64_t, 3> at{};
  for (int i = 0; i < 3; ++i)
    at[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(std::floor(p[i] / step_ + 0.5));
  add_to(best->moments, at);
  return inside;
}

}  // namespace limpet::benchmarks
