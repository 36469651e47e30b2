// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/evaluation/reachable_topology.hpp>

#include <limpet/evaluation/judgement.hpp>
#include <limpet/evaluation/planar_face.hpp>
#include <set>

namespace limpet::evaluation {
namespace {

constexpr double kWhole = 0.99;  // the share of a face that must be reachable

FacesReport faces_of(const model::ModelRecord& model, const simulation::Mesh& truth,
                     const Reachability& reachability, double resolution) {
  std::vector<simulation::LabelledPoint> points;  // perfect readings of all there is
  for (const SurfaceSample& sample : reachability.samples)
    points.push_back({{sample.at, -sample.normal}, sample.face});
  JudgeOptions options;
  options.resolution = resolution;
  return judge_faces(planar_faces(model), truth, points, options);
}

/// For each face the number it has among those that are kept; −1: it is not.
std::vector<int> numbers_of(const Reachability& reachability) {
  std::vector<int> numbers;
  int next = 0;
  for (const Reachability::Face& face : reachability.faces)
    numbers.push_back(face.share >= kWhole ? next++ : -1);
  return numbers;
}

simulation::Mesh part_of(const simulation::Mesh& truth, const std::vector<int>& numbers) {
  simulation::Mesh part;
  part.vertices = truth.vertices;
  for (const int number : numbers) part.face_count += number >= 0;
  for (std::size_t t = 0; t < truth.triangles.size(); ++t) {
    const int number = numbers[static_cast<std::size_t>(truth.face_of_triangle[t])];
    if (number < 0) continue;
    part.triangles.push_back(truth.triangles[t]);
    part.face_of_triangle.push_back(number);
  }
  return part;
}

bool stays(const PolygonJudgement& polygon, const std::vector<int>& numbers) {
  return polygon.face < 0 || numbers[static_cast<std::size_t>(polygon.face)] >= 0;
}

model::ModelRecord part_of(const model::ModelRecord& model, const FacesReport& faces,
                           const std::vector<int>& numbers) {
  model::ModelRecord part = model;
  part.polygon_segments.clear();
  std::set<std::uint64_t> edges;
  for (const PolygonJudgement& polygon : faces.polygons) {
    if (!stays(polygon, numbers)) continue;
    part.polygon_segments.push_back(model.polygon_segments[static_cast<std::size_t>(polygon.polygon)]);
    for (const auto& cycle : part.polygon_segments.back().cycles)
      for (const model::VertexRecord& vertex : cycle) edges.insert(vertex.edge);
  }
  for (auto& polygon : part.polygon_segments)
    for (auto& cycle : polygon.cycles)
      for (model::VertexRecord& vertex : cycle)
        if (edges.count(vertex.partner) == 0) vertex.partner = 0;
  return part;
}

/// Which polygon is which face, as far as judge_topology() asks.
FacesReport part_of(const FacesReport& faces, const std::vector<int>& numbers) {
  FacesReport part;
  for (const PolygonJudgement& polygon : faces.polygons) {
    if (!stays(polygon, numbers)) continue;
    PolygonJudgement& kept = part.polygons.emplace_back(polygon);
    kept.polygon = static_cast<int>(part.polygons.size()) - 1;
    if (kept.face >= 0) kept.face = numbers[static_cast<std::size_t>(kept.face)];
  }
  return part;
}

}  // namespace

ReachableTopology judge_reachable_topology(const model::ModelRecord& model, const simulation::Mesh& truth,
                                           const Reachability& reachability, double resolution) {
  const FacesReport faces = faces_of(model, truth, reachability, resolution);
  const std::vector<int> numbers = numbers_of(reachability);
  const simulation::Mesh part = part_of(truth, numbers);
  ReachableTopology result;
  result.faces = part.face_count;
  result.report = judge_topology(part_of(model, faces, numbers), part, part_of(faces, numbers));
  result.isomorphic = result.faces > 0 && result.report.isomorphic;
  return result;
}

}  // namespace limpet::evaluation
