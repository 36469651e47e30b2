// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/evaluation/subject.hpp>

#include <limpet/evaluation/judgement.hpp>
#include <limpet/io/native.hpp>
#include <limpet/io/text.hpp>

namespace limpet::evaluation {

Subject load_subject(const std::string& path) {
  if (io::extension_of(path) == "limpet") {
    const model::ModelRecord record = io::load_native(path);
    const Closedness found = closedness(record);
    return {planar_faces(record), found.edges, found.open_edges};
  }
  // A model may face inward as well as outward: it is compared as it stands.
  const simulation::Mesh mesh = simulation::load_mesh(path, simulation::kPlanarity, true);
  const simulation::EdgeCounts edges = simulation::count_edges(mesh);
  return {planar_faces(mesh), edges.edges, edges.open};
}

}  // namespace limpet::evaluation
