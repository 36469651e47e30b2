// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/kinematics/redundancy.hpp>

#include <Eigen/QR>
#include <cmath>

namespace limpet::kinematics {
namespace {

using Eigen::Vector3d;

/// A whole power, the same on every machine.
double power(double base, int exponent) {
  double result = 1;
  for (int i = 0; i < exponent; ++i) result *= base;
  return result;
}

double half_square(double length) { return length * length / 2; }

/// The term of one link in (5): how much each joint is to move to take the link's point away.
Eigen::VectorXd term(const Posture& posture, std::size_t link, const Vector3d& on_link, const Vector3d& away,
                     double d0, int exponent) {
  const double d = half_square(away.norm());
  return power(1 - d / d0, exponent - 1) * (posture.jacobian(link, on_link).transpose() * away);
}

}  // namespace

double objective(std::span<const Proximity> proximities, const RedundancyParameters& p) {
  const double d0 = half_square(p.influence);
  double sum = 0;
  for (const Proximity& near : proximities) {
    const double d = half_square((near.on_link - near.obstacle).norm());
    if (d < d0) sum += power(1 - d / d0, p.exponent);
  }
  return d0 / p.exponent * sum;
}

Eigen::VectorXd reconfiguration(const Posture& posture, std::span<const Proximity> proximities,
                                const RedundancyParameters& p) {
  const double d0 = half_square(p.influence);
  Eigen::VectorXd z = Eigen::VectorXd::Zero(posture.configuration().size());
  for (const Proximity& near : proximities) {
    const Vector3d away = near.on_link - near.obstacle;
    if (half_square(away.norm()) < d0) z += term(posture, near.link, near.on_link, away, d0, p.exponent);
  }
  return z;
}

Eigen::VectorXd reconfiguration(const Posture& posture, std::span<const ProximitySwitch> switches,
                                std::span<const std::size_t> seeing, int exponent) {
  Eigen::VectorXd z = Eigen::VectorXd::Zero(posture.configuration().size());
  for (const std::size_t i : seeing) {
    const ProximitySwitch& s = switches[i];
    const Eigen::Isometry3d& link = posture.link(s.link);
    const Vector3d at = link * s.position;
    z += term(posture, s.link, at, at - link * s.field_centre(), half_square(s.range), exponent);
  }
  return z;
}

Configuration redundant_changes(const Posture& posture, const Vector3d& motion, const Eigen::VectorXd& z,
                                double gain) {
  const Eigen::MatrixXd jacobian = posture.jacobian();
  if (jacobian.cols() == 0) return Configuration();
  const auto inverse = jacobian.completeOrthogonalDecomposition();
  const Eigen::VectorXd wanted = gain * z;
  return inverse.solve(motion) + wanted - inverse.solve(jacobian * wanted);
}

}  // namespace limpet::kinematics
