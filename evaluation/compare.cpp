// Copyright the limpet authors. GPL-3.0-or-later.
#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <limpet/evaluation/judgement.hpp>
#include <limpet/evaluation/region.hpp>

namespace limpet::evaluation {
namespace {

using Eigen::Vector3d;

/// The samples stand for equal areas and give mean and quantiles; the vertices count for the maximum alone.
DistanceSummary summary(const std::vector<Triangle3>& from, const NearestSurface& to, int samples) {
  std::vector<double> distances;
  for (const Vector3d& p : spread_over(from, samples)) distances.push_back(to.distance(p));
  DistanceSummary result;
  if (distances.empty()) {
    const double infinite = std::numeric_limits<double>::infinity();
    return {infinite, infinite, infinite, infinite, infinite};
  }
  std::sort(distances.begin(), distances.end());
  const auto percentile = [&distances](double share) {
    return distances[static_cast<std::size_t>(share * static_cast<double>(distances.size() - 1))];
  };
  for (const double d : distances) result.mean += d / static_cast<double>(distances.size());
  result.median = percentile(0.5);
  result.p90 = percentile(0.9);
  result.p99 = percentile(0.99);
  result.max = distances.back();
  for (const Triangle3& triangle : from)
    for (const Vector3d& vertex : triangle) result.max = std::max(result.max, to.distance(vertex));
  return result;
}

double farthest(const PlanarFace& from, const PlanarFace& to, double spacing) {
  const NearestLine line(boundary_segments(to));
  double result = 0;
  for (const Vector3d& p : along_boundary(from, spacing)) result = std::max(result, line.distance(p));
  return result;
}

}  // namespace

Comparison compare(const std::vector<PlanarFace>& model, const simulation::Mesh& truth, int samples) {
  Comparison result;
  std::vector<Triangle3> of_model, of_truth;
  for (const PlanarFace& face : model) {
    const std::vector<Triangle3> triangles = triangulated(face);
    of_model.insert(of_model.end(), triangles.begin(), triangles.end());
  }
  for (const auto& [a, b, c] : truth.triangles)
    of_truth.push_back({truth.vertices[a], truth.vertices[b], truth.vertices[c]});
  for (const Triangle3& t : of_model) result.model_area += (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2;
  for (const Triangle3& t : of_truth) result.true_area += (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2;
  result.model_to_truth = summary(of_model, NearestSurface(of_truth), samples);
  result.truth_to_model = summary(of_truth, NearestSurface(of_model), samples);
  result.polygons = static_cast<std::int64_t>(model.size());
  result.true_faces = truth.face_count;
  return result;
}

Closedness closedness(const model::ModelRecord& record) {
  Closedness result;
  const std::vector<PlanarFace> faces = planar_faces(record);
  for (std::size_t s = 0; s < faces.size(); ++s) {
    for (std::size_t c = 0; c < faces[s].cycles.size(); ++c) {
      const std::vector<Vector3d>& cycle = faces[s].cycles[c];
      for (std::size_t i = 0; i < cycle.size(); ++i) {
        const double length = (cycle[(i + 1) % cycle.size()] - cycle[i]).norm();
        ++result.edges;
        result.length += length;
        if (record.polygon_segments[s].cycles[c][i].partner != 0) continue;
        ++result.open_edges;
        result.open_length += length;
      }
    }
  }
  return result;
}

double boundary_distance(const PlanarFace& a, const PlanarFace& b, double spacing) {
  return std::max(farthest(a, b, spacing), farthest(b, a, spacing));
}

BoundaryComparison compare_boundaries(const std::vector<PlanarFace>& a, const std::vector<PlanarFace>& b,
                                      double resolution) {
  const double max_angle_rad = JudgeOptions{}.max_angle_rad;
  const std::vector<Region> regions_a = regions(a), regions_b = regions(b);
  const std::vector<int> a_on = matches(regions_a, regions_b, resolution, max_angle_rad);
  const std::vector<int> b_on = matches(regions_b, regions_a, resolution, max_angle_rad);
  BoundaryComparison result;
  for (int i = 0; i < static_cast<int>(a.size()); ++i) {
    const int j = a_on[i];
    if (j < 0 || b_on[j] != i) {
      result.only_a.push_back(i);
      continue;
    }
    const double distance = boundary_distance(a[i], b[j], resolution / 4);
    result.pairs.push_back({i, j, distance});
    result.max_distance = std::max(result.max_distance, distance);
  }
  for (int j = 0; j < static_cast<int>(b.size()); ++j)
    if (b_on[j] < 0 || a_on[b_on[j]] != j) result.only_b.push_back(j);
  return result;
}

}  // namespace limpet::evaluation
