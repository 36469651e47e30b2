// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/simulation/scan_pattern.hpp>
#include <vector>

namespace limpet::simulation {

/// A terrestrial laser scanner at each of several viewpoints, upright (z): it sends rays at equal angles
/// along a vertical half circle, from 60° below the horizon (below is its tripod) to the zenith, turns about
/// the vertical axis by the same angle, and so on all around. The pitch is that angle in radians.
class TurningScanner : public ScanPattern {
 public:
  TurningScanner(const Mesh& mesh, const std::vector<Eigen::Vector3d>& viewpoints)
      : ScanPattern(mesh), viewpoints_(viewpoints) {}

 private:
  void send(double pitch, const Send&) const override;
  double extent() const override;

  std::vector<Eigen::Vector3d> viewpoints_;
};

}  // namespace limpet::simulation
