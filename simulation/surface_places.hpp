// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/simulation/mesh.hpp>
#include <limpet/survey/random.hpp>
#include <vector>

namespace limpet::simulation {

/// Random places of a surface, uniform over its area.
class SurfacePlaces {
 public:
  /// The mesh must outlive it. Throws MeshError when the surface has no area.
  explicit SurfacePlaces(const Mesh&);

  struct Place {
    Eigen::Vector3d position;
    int triangle = 0;
  };
  Place next(survey::Random&) const;

 private:
  const Mesh& mesh_;
  std::vector<double> area_up_to_;  ///< and with each triangle, twice
};

}  // namespace limpet::simulation
