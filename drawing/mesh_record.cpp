// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/drawing/mesh_record.hpp>

#include <Eigen/Geometry>
#include <array>
#include <limpet/evaluation/topology.hpp>
#include <map>
#include <utility>

namespace limpet::drawing {

model::ModelRecord record_of(const simulation::Mesh& mesh) {
  const auto faces = simulation::faces_of(mesh);
  const auto loops_of = evaluation::side_loops(mesh);
  const auto key = [](const Eigen::Vector3d& p) { return std::array<double, 3>{p.x(), p.y(), p.z()}; };
  // An edge is found by its ends in the loop's direction; its partner has the same ends reversed.
  using Side = std::pair<std::array<double, 3>, std::array<double, 3>>;
  std::map<Side, std::uint64_t> edge_of;
  model::ModelRecord record;
  record.grid_step = 1;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    auto& segment = record.polygon_segments.emplace_back();
    segment.id = f + 1;
    segment.chart_origin = faces[f].centroid;
    segment.chart_normal = faces[f].normal;
    segment.chart_u = faces[f].normal.unitOrthogonal();
    segment.chart_v = faces[f].normal.cross(segment.chart_u);
    for (const auto& loop : loops_of[f]) {
      auto& cycle = segment.cycles.emplace_back();
      for (std::size_t i = 0; i < loop.begins.size(); ++i) {
        const Eigen::Vector3d d = loop.begins[i] - segment.chart_origin;
        cycle.push_back({d.dot(segment.chart_u), d.dot(segment.chart_v), record.next_edge, 0});
        edge_of[{key(loop.begins[i]), key(loop.begins[(i + 1) % loop.begins.size()])}] = record.next_edge++;
      }
    }
  }
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t c = 0; c < loops_of[f].size(); ++c) {
      const auto& begins = loops_of[f][c].begins;
      for (std::size_t i = 0; i < begins.size(); ++i)
        if (const auto partner = edge_of.find({key(begins[(i + 1) % begins.size()]), key(begins[i])});
            partner != edge_of.end())
          record.polygon_segments[f].cycles[c][i].partner = partner->second;
    }
  return record;
}

}  // namespace limpet::drawing
