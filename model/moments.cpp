// Copyright the limpet authors. GPL-3.0-or-later.
#include "moments_internal.hpp"

namespace limpet::model {

void Moments::add(const Moments& other) {
  count_ += other.count_;
  for (std::size_t i = 0; i < 3; ++i) sum_[i] += other.sum_[i];
  for (std::size_t i = 0; i < 6; ++i) product_[i] += other.product_[i];
}

std::array<std::int64_t, 3> Moments::rounded_mean() const {
  std::array<std::int64_t, 3> c{};
  for (std::size_t i = 0; i < 3; ++i) c[i] = static_cast<std::int64_t>(sum_[i] / count_);
  return c;
}

Eigen::Vector3d Moments::centroid(double step) const {
  const auto c = rounded_mean();
  Eigen::Vector3d mean;
  for (int i = 0; i < 3; ++i) {
    const auto rest = static_cast<double>(sum_[i] - count_ * Int128{c[i]});
    mean[i] = step * (static_cast<double>(c[i]) + rest / static_cast<double>(count_));
  }
  return mean;
}

Eigen::Matrix3d Moments::covariance(double step) const {
  // About c, the mean rounded to whole steps, all sums stay integers: Σ(x−cx)(y−cy) = Σxy − cx Σy − cy Σx + m
  // cx cy.
  const auto c = rounded_mean();
  const Int128 m = count_;
  const auto n = static_cast<double>(count_);
  Eigen::Vector3d d;
  for (int i = 0; i < 3; ++i) d[i] = static_cast<double>(sum_[i] - m * c[i]) / n;
  Eigen::Matrix3d covariance;
  constexpr std::array<std::array<int, 3>, 3> place = {{{0, 1, 2}, {1, 3, 4}, {2, 4, 5}}};
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) {
      const Int128 central = product_[place[i][j]] - c[i] * sum_[j] - c[j] * sum_[i] + m * c[i] * c[j];
      covariance(i, j) = covariance(j, i) = step * step * (static_cast<double>(central) / n - d[i] * d[j]);
    }
  return covariance;
}

double Moments::squared_residual(const geometry::Plane& plane, double step) const {
  const double height = plane.height_of(centroid(step));
  const double spread = count_ > 1 ? plane.normal.dot(covariance(step) * plane.normal) : 0.0;
  return std::max(0.0, spread) + height * height;
}

}  // namespace limpet::model
