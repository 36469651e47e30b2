// Copyright the limpet authors. GPL-3.0-or-later.
#include <Eigen/Geometry>
#include <limpet/io/lifted.hpp>

namespace limpet::io {
namespace {

LiftedCycle lift_cycle(const model::PolygonSegmentRecord& segment,
                       const std::vector<model::VertexRecord>& cycle, double step) {
  LiftedCycle lifted;
  lifted.reserve(cycle.size());
  for (const model::VertexRecord& vertex : cycle) {
    const double x = vertex.x, y = vertex.y;
    const double h = segment.height[0] + segment.height[1] * x + segment.height[2] * y;
    lifted.push_back(
        {segment.chart_origin + step * (x * segment.chart_u + y * segment.chart_v + h * segment.chart_normal),
         {x, y},
         vertex.edge,
         vertex.partner});
  }
  return lifted;
}

}  // namespace

std::vector<LiftedPolygon> lift(const model::ModelRecord& model) {
  std::vector<LiftedPolygon> polygons;
  polygons.reserve(model.polygon_segments.size());
  for (const model::PolygonSegmentRecord& segment : model.polygon_segments) {
    LiftedPolygon& polygon = polygons.emplace_back();
    polygon.id = segment.id;
    polygon.points = segment.moments.count;
    // (u + hx·n) × (v + hy·n) for a right-handed orthonormal frame u, v, n.
    const Eigen::Vector3d normal =
        segment.chart_normal - segment.height[1] * segment.chart_u - segment.height[2] * segment.chart_v;
    polygon.normal = normal.normalized();
    for (const auto& cycle : segment.cycles) {
      polygon.cycles.push_back(lift_cycle(segment, cycle, model.grid_step));
    }
  }
  return polygons;
}

Eigen::Vector3d centroid(const model::MomentsRecord& moments, double grid_step) {
  // The whole part first and exactly: a sum of 10⁸ large coordinates does not fit a double.
  Eigen::Vector3d mean;
  for (int i = 0; i < 3; ++i) {
    const model::Int128 whole = moments.sum[i] / moments.count, rest = moments.sum[i] % moments.count;
    mean[i] = static_cast<double>(whole) + static_cast<double>(rest) / static_cast<double>(moments.count);
  }
  return grid_step * mean;
}

double area(const LiftedPolygon& polygon) {
  double twice = 0;
  for (const LiftedCycle& cycle : polygon.cycles) {
    for (std::size_t i = 1; i + 1 < cycle.size(); ++i) {
      const Eigen::Vector3d a = cycle[i].at - cycle[0].at, b = cycle[i + 1].at - cycle[0].at;
      twice += a.cross(b).dot(polygon.normal);
    }
  }
  return twice / 2;
}

}  // namespace limpet::io
