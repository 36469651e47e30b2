// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limpet/evaluation/coverage.hpp>
#include <limpet/evaluation/reachable.hpp>
#include <vector>

namespace limpet::evaluation {

/// An edge of the model that a run has given up: it said that the surface beyond cannot be reached, or that
/// the edge cannot be closed. World frame.
struct GivenUp {
  Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();
  /// Unit vector in the plane of the edge's segment, away from the segment.
  Eigen::Vector3d outward = Eigen::Vector3d::UnitX();
};

/// Which marks the offline search contradicts.
struct FalseUnreachable {
  std::size_t count = 0;      ///< marks with some such surface beyond
  std::vector<double> areas;  ///< beyond each mark, what is reachable without doubt and not covered
};

/// Looks beyond each mark for surface that is reachable without doubt and more than λ from the model. A
/// sample is *beyond* a mark when it
///   - is within 2λ of the edge, and no farther than λ/2 behind it (outward·(sample − nearest point) ≥ −λ/2:
///     a surface folds down beyond a convex edge that the model stops short of);
///   - is joined to the edge over the true surface: by samples with these properties, each within two
///     spacings of the next, from one that is within λ of the edge. What lies across a gap is none of it.
/// What an earlier mark is contradicted by may contradict a later one, too. `covered` is that of the same
/// samples. Precondition: λ > 0.
FalseUnreachable false_unreachable(const std::vector<GivenUp>& marks, const Reachability& truth,
                                   const Coverage& covered, double resolution);

/// The samples that may be beyond a mark: those within 2λ of an edge.
std::vector<SurfaceSample> near_marks(const std::vector<GivenUp>& marks,
                                      const std::vector<SurfaceSample>& samples, double resolution);

}  // namespace limpet::evaluation
