// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/geometry/chart.hpp>

#include <Eigen/Geometry>
#include <cmath>

namespace limpet::geometry {

double grid_step_for(double length) {
  double step = 1;
  while (step < length / 4096) step *= 2;
  while (step / 2 >= length / 4096) step /= 2;
  return step;
}

Chart::Chart(const Plane& plane, const Eigen::Vector3d& hint, double step)
    : origin_(plane.point), normal_(plane.normal), step_(step) {
  u_ = hint - hint.dot(normal_) * normal_;
  u_ /= std::sqrt(u_.dot(u_));
  v_ = normal_.cross(u_);
  v_ /= std::sqrt(v_.dot(v_));
}

Lift::Lift(const Chart& chart, const Plane& plane) {
  const double a = plane.normal.dot(chart.u()), b = plane.normal.dot(chart.v()),
               c = plane.normal.dot(chart.normal());
  h0 = plane.normal.dot(plane.point - chart.origin()) / c / chart.step();
  hx = -a / c;
  hy = -b / c;
}

Plane Lift::plane(const Chart& chart) const {
  Eigen::Vector3d n = chart.normal() - hx * chart.u() - hy * chart.v();
  n /= std::sqrt(n.dot(n));
  return {chart.at({0, 0}, h0), n};
}

}  // namespace limpet::geometry
