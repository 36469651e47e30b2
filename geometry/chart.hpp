// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <array>

#include <limpet/geometry/types.hpp>

namespace limpet::geometry {

/// A plane in the world: through `point`, with the unit vector `normal` pointing out of the surface.
struct Plane {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double height_of(const Eigen::Vector3d& p) const { return normal.dot(p - point); }
};

/// The grid step of a model whose resolution is `length`: the smallest power of two not below length/4096.
///  (1) Scaling the length by a power of two scales the step by the same.
double grid_step_for(double length);

/// The planar frame a perimeter lives in, fixed when its segment is born: origin in the world, orthonormal
/// axes u, v and normal n = u × v. Chart coordinates are in grid steps along u and v.
///  (1) project() is the inverse of at(), at any height, up to rounding.
class Chart {
 public:
  Chart() = default;
  /// A chart on the plane. u is the direction of `hint` projected onto the plane; `hint` must not be parallel
  /// to the normal.
  Chart(const Plane& plane, const Eigen::Vector3d& hint, double step);
  Chart(const Eigen::Vector3d& origin, const Eigen::Vector3d& u, const Eigen::Vector3d& v,
        const Eigen::Vector3d& normal, double step)
      : origin_(origin), u_(u), v_(v), normal_(normal), step_(step) {}

  /// The point's projection along the chart's normal, not rounded.
  Point2 project(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d d = p - origin_;
    return {d.dot(u_) / step_, d.dot(v_) / step_};
  }
  /// The world position of a chart point lifted by `height` (grid steps) along the normal.
  Eigen::Vector3d at(Point2 p, double height) const {
    return origin_ + step_ * (p.x * u_ + p.y * v_ + height * normal_);
  }

  const Eigen::Vector3d& origin() const { return origin_; }
  const Eigen::Vector3d& u() const { return u_; }
  const Eigen::Vector3d& v() const { return v_; }
  const Eigen::Vector3d& normal() const { return normal_; }
  double step() const { return step_; }

 private:
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d u_ = Eigen::Vector3d::UnitX(), v_ = Eigen::Vector3d::UnitY(),
                  normal_ = Eigen::Vector3d::UnitZ();
  double step_ = 1;
};

/// A plane as an affine height map over a chart, in grid steps: it lifts chart points along the chart's
/// normal onto the plane.
///  (1) Lifted points lie on the plane, (2) and plane() gives that plane back, both up to rounding.
struct Lift {
  double h0 = 0, hx = 0, hy = 0;

  Lift() = default;
  /// Precondition: the plane is not perpendicular to the chart.
  Lift(const Chart&, const Plane&);

  double operator()(Point2 p) const { return h0 + hx * p.x + hy * p.y; }
  /// Tangent of the angle between plane and chart, squared.
  double squared_tilt() const { return hx * hx + hy * hy; }
  Plane plane(const Chart&) const;
};

}  // namespace limpet::geometry
