// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/following/thesis/edges_internal.hpp>
#include <limpet/model/model.hpp>
#include <limpet/model/view.hpp>
#include <limpet/simulation/initial_faces.hpp>
#include <limpet/simulation/shapes.hpp>
#include <vector>

namespace limpet::following {

using Cycle = std::vector<Eigen::Vector3d>;

/// A model of known faces only: each a list of cycles, the outer one first.
inline model::Model initial_model(const std::vector<std::vector<Cycle>>& faces) {
  model::Model model(model::Parameters{});
  std::vector<model::InitialFace> initial;
  for (const auto& cycles : faces) initial.push_back({cycles});
  model.add_initial(initial);
  return model;
}

inline Cycle rectangle(double x0, double y0, double x1, double y1, double z = 0) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}
/// Clockwise: the rim of a hole.
inline Cycle hole(double x0, double y0, double x1, double y1, double z = 0) {
  return {{x0, y0, z}, {x0, y1, z}, {x1, y1, z}, {x1, y0, z}};
}

inline std::vector<model::View::Edge> edges_of(const model::Model& model, model::SegmentId id) {
  std::vector<model::View::Edge> edges;
  model.view().edges(id, edges);
  return edges;
}
inline std::vector<model::SegmentId> segments_of(const model::Model& model) {
  std::vector<model::SegmentId> segments;
  model.view().segments(segments);
  return segments;
}
/// The segment's edge nearest to a place.
inline model::View::Edge edge_at(const model::Model& model, model::SegmentId id, const Eigen::Vector3d& p) {
  const auto edges = edges_of(model, id);
  return edges[internal::nearest_edge(edges, p)];
}
/// A cube of side 1 whose edges are all shared.
inline model::Model shared_cube() {
  model::Model model(model::Parameters{});
  model.add_initial(simulation::initial_faces(simulation::make_shape("cube")));
  model.finish();
  return model;
}

}  // namespace limpet::following
