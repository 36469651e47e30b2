// Copyright the limpet authors. GPL-3.0-or-later.
//
// Initial model segments (thesis §4.3): faces known beforehand. They represent no sensor points, merge with
// nothing and are never modified, but they share edges and corners. Points on them are counted
// (Insertion::insert_one()).
#include <stdexcept>

#include <limpet/geometry/predicates.hpp>

#include "initial_internal.hpp"

namespace limpet::model::internal {
namespace {

/// Twice the area of a cycle, as a vector along its normal.
Eigen::Vector3d area_vector(const std::vector<Eigen::Vector3d>& cycle) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < cycle.size(); ++i)
    sum += (cycle[i] - cycle[0]).cross(cycle[i + 1] - cycle[0]);
  return sum;
}

[[noreturn]] void refuse(std::size_t face, const char* what) {
  throw std::invalid_argument("initial face " + std::to_string(face) + " " + what);
}

}  // namespace

void add_initial(Complex& complex, std::size_t number, const InitialFace& face) {
  if (face.cycles.empty() || face.cycles.front().size() < 3) refuse(number, "has fewer than three vertices");
  const auto& outer = face.cycles.front();
  Eigen::Vector3d centre = Eigen::Vector3d::Zero(), normal = area_vector(outer);
  for (const auto& v : outer) centre += v / static_cast<double>(outer.size());
  const double length = std::sqrt(normal.dot(normal));
  if (!(length > 0) || !std::isfinite(length) || !std::isfinite(centre.sum())) refuse(number, "has no area");
  normal /= length;

  auto polygon = std::make_unique<PolygonPart>();
  PolygonPart& part = *polygon;
  part.chart = geometry::Chart({centre, normal}, outer[1] - outer[0], complex.setting().step);
  part.published = geometry::Lift(part.chart, {centre, normal});
  part.outward = normal;
  part.initial = {centre, normal};
  std::vector<std::vector<geometry::NewVertex>> cycles;
  for (const auto& cycle : face.cycles) {
    auto& vertices = cycles.emplace_back();
    for (const Eigen::Vector3d& v : cycle)
      vertices.push_back({geometry::round_to_grid(part.chart.project(v))});
  }
  auto perimeter = geometry::Polygon::from_cycles(cycles, complex.edge_ids());
  if (!perimeter) refuse(number, "is no simple polygon at this resolution");
  part.perimeter = std::move(*perimeter);
  Fit fit;
  fit.centroid = centre, fit.normal = normal;
  complex.create_initial(fit, std::move(polygon));
}

}  // namespace limpet::model::internal
