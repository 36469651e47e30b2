// Copyright the limpet authors. GPL-3.0-or-later.
#include "fit_internal.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace limpet::model {

double Fit::normal_error(double variance) const {
  return std::sqrt(variance / (count * std::max(u2, 1e-300)));
}

Fit fit_to(const Moments& moments, double step, const Eigen::Vector3d& inside) {
  Fit fit;
  fit.count = static_cast<double>(moments.count());
  fit.centroid = moments.centroid(step);
  if (moments.count() < 2) {
    fit.normal = -inside;
    return fit;
  }
  // compute(), not computeDirect(): it needs no trigonometry, so the bits are the same everywhere.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments.covariance(step));
  fit.u3 = std::max(0.0, solver.eigenvalues()[0]);
  fit.u2 = std::max(0.0, solver.eigenvalues()[1]);
  fit.u1 = std::max(0.0, solver.eigenvalues()[2]);
  fit.normal = solver.eigenvectors().col(0);
  fit.axis2 = solver.eigenvectors().col(1);
  fit.axis1 = solver.eigenvectors().col(2);
  if (fit.normal.dot(inside) > 0) fit.normal = -fit.normal;
  return fit;
}

}  // namespace limpet::model
