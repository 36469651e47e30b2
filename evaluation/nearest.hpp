// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/evaluation/planar_face.hpp>
#include <memory>
#include <utility>
#include <vector>

namespace limpet::evaluation {

/// Distances to a set of triangles. Triangles without area are left out.
class NearestSurface {
 public:
  explicit NearestSurface(const std::vector<Triangle3>& triangles);
  ~NearestSurface();
  NearestSurface(NearestSurface&&) noexcept;
  NearestSurface& operator=(NearestSurface&&) noexcept;

  /// Infinite if there is no triangle.
  double distance(const Eigen::Vector3d& from) const;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

/// Distances to a set of line segments. Segments without length are left out.
class NearestLine {
 public:
  explicit NearestLine(const std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>& segments);
  ~NearestLine();
  NearestLine(NearestLine&&) noexcept;
  NearestLine& operator=(NearestLine&&) noexcept;

  /// Infinite if there is no segment.
  double distance(const Eigen::Vector3d& from) const;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace limpet::evaluation
