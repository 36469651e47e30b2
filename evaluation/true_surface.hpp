// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/simulation/mesh.hpp>
#include <memory>
#include <optional>

namespace limpet::evaluation {

/// The surface that a simulated robot moves over, as the judge knows it: how far it is, and what crosses it.
/// Triangles without area are left out. World frame, scan's unit.
class TrueSurface {
 public:
  explicit TrueSurface(const simulation::Mesh& mesh);
  ~TrueSurface();
  TrueSurface(TrueSurface&&) noexcept;
  TrueSurface& operator=(TrueSurface&&) noexcept;

  /// Distance of a place, right up to rounding; infinite if there is no triangle.
  double distance(const Eigen::Vector3d& place) const;
  /// Distance of the whole straight way from a to b, right up to rounding; 0 if it meets the surface.
  double distance_along(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;
  /// distance_along(a, b) ≥ least, but cheaper. Precondition: least > 0.
  bool keeps(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double least) const;
  /// Does the way, with both its ends, touch or cross a triangle? Decided exactly.
  bool meets(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;
  /// How far a ray runs before it meets the surface, from whichever side; none: it never does. Precondition:
  /// `direction` is a unit vector.
  std::optional<double> first_crossing(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const;

 private:
  double distance_of_edges(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double within) const;

  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace limpet::evaluation
