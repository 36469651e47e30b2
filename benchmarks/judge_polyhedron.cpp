// Copyright the limpet authors. GPL-3.0-or-later.
#include <Eigen/Geometry>

#include <limpet/evaluation/judgement.hpp>
#include <limpet/evaluation/region.hpp>

#include "sections.hpp"

namespace limpet::benchmarks {
namespace {

using evaluation::PlanarFace;
using simulation::Mesh;

/// One by one, since a mesh of any origin need not have faces with proper boundaries.
std::vector<PlanarFace> triangles_of(const Mesh& mesh) {
  std::vector<PlanarFace> triangles;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    triangles.push_back({.id = t,
                         .cycles = {{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}},
                         .normal = simulation::area_vector(mesh, static_cast<int>(t)).normalized()});
  }
  return triangles;
}

double area_on(const std::vector<evaluation::Region>& triangles, const std::vector<evaluation::Region>& truth,
               double reach) {
  const std::vector<int> faces =
      evaluation::matches(triangles, truth, reach, evaluation::JudgeOptions{}.max_angle_rad);
  double area = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (faces[t] >= 0) area += triangles[t].area;
  return area;
}

/// All but a hundredth of what lies on true faces faces their way.
bool faces_as_truth(std::vector<PlanarFace> triangles, const Mesh& truth, double reach) {
  const auto true_faces = evaluation::regions(evaluation::planar_faces(truth));
  const double right = area_on(evaluation::regions(triangles), true_faces, reach);
  for (PlanarFace& t : triangles) t.normal = -t.normal;
  const double turned = area_on(evaluation::regions(triangles), true_faces, reach);
  return 99 * turned < right;
}

}  // namespace

Json answer_judgement(const Json& request) {
  const ScanCase scan_case(request.at("spec").get<CloudSpec>());
  const Mesh& truth = scan_case.scene.mesh;
  const double lambda = scan_case.resolution;
  const Mesh mesh = simulation::load_mesh(request.at("mesh"), simulation::kPlanarity, true);
  const std::vector<PlanarFace> triangles = triangles_of(mesh);
  const simulation::EdgeCounts edges = simulation::count_edges(mesh);
  const auto comparison = evaluation::compare(triangles, truth);
  const bool has_volume = edges.open == 0 && simulation::count_edges(truth).open == 0;
  const bool outward = has_volume ? edges.crowded == 0 && simulation::signed_volume(mesh) > 0
                                  : faces_as_truth(triangles, truth, lambda);
  return {{"closed", edges.open == 0},
          {"outward", outward},
          {"merged_faces", mesh.face_count},
          {"model_to_truth", comparison.model_to_truth.max / lambda},
          {"truth_to_model", comparison.truth_to_model.max / lambda}};
}

}  // namespace limpet::benchmarks
