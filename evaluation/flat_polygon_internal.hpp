// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/evaluation/planar_face.hpp>
#include <vector>

namespace limpet::evaluation {

/// A planar face in coordinates of its own plane: axes u, v with u × v along the normal, scan's unit.
/// Precondition: cycles have the interior on their left, as those of a model have.
class FlatPolygon {
 public:
  explicit FlatPolygon(const PlanarFace& face);

  Eigen::Vector2d flat(const Eigen::Vector3d& world) const;
  Eigen::Vector3d raised(const Eigen::Vector2d& place) const;
  /// Over the plane, outward.
  double height(const Eigen::Vector3d& world) const { return (world - origin_).dot(normal_); }

  /// Inside an odd number of cycles.
  bool inside(const Eigen::Vector2d& place) const;
  /// Area of the part within a disc.
  double area_within(const Eigen::Vector2d& centre, double radius) const;

 private:
  template <class Visit>
  void each_edge(const Visit& visit) const;

  Eigen::Vector3d origin_, u_, v_, normal_;
  std::vector<std::vector<Eigen::Vector2d>> cycles_;
};

}  // namespace limpet::evaluation
