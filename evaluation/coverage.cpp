// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/evaluation/coverage.hpp>

#include <limpet/evaluation/nearest.hpp>

namespace limpet::evaluation {
namespace {

NearestSurface surface_of(const std::vector<PlanarFace>& model) {
  std::vector<Triangle3> triangles;
  for (const PlanarFace& face : model) {
    const std::vector<Triangle3> some = triangulated(face);
    triangles.insert(triangles.end(), some.begin(), some.end());
  }
  return NearestSurface(triangles);
}

/// Areas that are counted while the samples are gone through.
struct Tally {
  double reachable = 0, all = 0, covered_reachable = 0, covered_all = 0;

  void add(const SurfaceSample& sample, Verdict verdict, bool covered) {
    all += sample.area;
    if (covered) covered_all += sample.area;
    if (verdict != Verdict::yes) return;
    reachable += sample.area;
    if (covered) covered_reachable += sample.area;
  }
  Coverage::Face shares() const {
    return {reachable > 0 ? covered_reachable / reachable : 0, all > 0 ? covered_all / all : 0};
  }
};

}  // namespace

Coverage coverage_of(const std::vector<PlanarFace>& model, const Reachability& truth, double resolution) {
  const NearestSurface surface = surface_of(model);
  Tally total;
  std::vector<Tally> of_face(truth.faces.size());
  Coverage result;
  for (std::size_t i = 0; i < truth.samples.size(); ++i) {
    const SurfaceSample& sample = truth.samples[i];
    const bool covered = surface.distance(sample.at) <= resolution;
    result.covered.push_back(covered);
    total.add(sample, truth.verdicts[i], covered);
    of_face[static_cast<std::size_t>(sample.face)].add(sample, truth.verdicts[i], covered);
  }
  for (const Tally& face : of_face) result.faces.push_back(face.shares());
  result.of_reachable = total.shares().of_reachable;
  result.of_all = total.shares().of_all;
  return result;
}

}  // namespace limpet::evaluation
