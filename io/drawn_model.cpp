// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <limpet/io/triangulate.hpp>
#include <limpet/io/welded.hpp>

#include "drawn_model_internal.hpp"

namespace limpet::io::internal {

DrawnModel drawn(const model::ModelRecord& model) {
  DrawnModel result;
  result.polygons = lift(model);
  const double reach = std::max(model.parameters.resolution, 8 * model.grid_step);
  const WeldedVertices welded = weld(result.polygons, reach);
  for (const int vertex : welded.welded)
    result.vertices.push_back(welded.at[static_cast<std::size_t>(vertex)]);
  std::uint32_t next = 0;
  for (const LiftedPolygon& polygon : result.polygons) {
    result.first.push_back(next);
    for (const LiftedCycle& cycle : polygon.cycles) {
      const auto size = static_cast<std::uint32_t>(cycle.size());
      for (std::uint32_t i = 0; i < size; ++i) {
        const LiftedVertex& vertex = cycle[i];
        if (!vertex.shared() || vertex.edge < vertex.partner)
          result.lines.push_back(
              {{next + i, next + (i + 1) % size}, polygon.id, vertex.edge, vertex.partner});
      }
      next += size;
    }
  }
  return result;
}

std::vector<std::array<std::uint32_t, 3>> triangles_of(const DrawnModel& model, std::size_t polygon) {
  std::vector<std::vector<Eigen::Vector2d>> cycles;
  for (const LiftedCycle& cycle : model.polygons[polygon].cycles) {
    auto& flat = cycles.emplace_back();
    for (const LiftedVertex& vertex : cycle) flat.push_back(vertex.chart);
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const Triangle& triangle : triangulate(cycles)) {
    auto& corners = triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = model.first[polygon] + static_cast<std::uint32_t>(triangle[k]);
  }
  return triangles;
}

}  // namespace limpet::io::internal
