// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/evaluation/planar_face.hpp>
#include <limpet/evaluation/reachable.hpp>
#include <vector>

namespace limpet::evaluation {

/// How much of the true surface a model shows, by area. Shares are from 0 to 1; a share of nothing is 0.
struct Coverage {
  double of_reachable = 0;  ///< of the area that is reachable without doubt, what is within λ of the model
  double of_all = 0;        ///< of the whole true surface
  /// For each true face.
  struct Face {
    double of_reachable = 0, of_all = 0;
  };
  std::vector<Face> faces;
  std::vector<char> covered;  ///< of each sample: is it within λ of the model?
};

/// Measures at the samples of `truth`. The normals are not looked at: where the object is thinner than λ, the
/// model of one side covers the other, too. Precondition: resolution λ > 0.
Coverage coverage_of(const std::vector<PlanarFace>& model, const Reachability& truth, double resolution);

}  // namespace limpet::evaluation
