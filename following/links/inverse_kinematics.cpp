// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/following/links/inverse_kinematics.hpp>

#include <Eigen/Cholesky>

namespace limpet::following {
using kinematics::Configuration;
using kinematics::Posture;
using kinematics::Robot;

std::optional<Configuration> led_to(const Robot& robot, Configuration from, const TaskIn& task,
                                    double precision) {
  constexpr int kSteps = 40;
  constexpr double kDamping = 1e-3, kLongest = 0.4;
  for (int i = 0; i < kSteps; ++i) {
    const auto [way, jacobian] = task(Posture(robot, from));
    if (way.norm() < precision) return from;
    const Eigen::Matrix3d square =
        jacobian * jacobian.transpose() + kDamping * jacobian.squaredNorm() * Eigen::Matrix3d::Identity();
    Configuration step = jacobian.transpose() * square.ldlt().solve(way);
    if (step.norm() > kLongest) step *= kLongest / step.norm();
    from = kinematics::within_limits(robot, from + step);
  }
  return std::nullopt;
}

}  // namespace limpet::following
