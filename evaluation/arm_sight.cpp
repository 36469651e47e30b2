// Copyright the limpet authors. GPL-3.0-or-later.
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limpet/evaluation/arm_sight_internal.hpp>

namespace limpet::evaluation {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using kinematics::Configuration;
using kinematics::Posture;

constexpr int kSteps = 40;             // of Newton's method
constexpr double kDamping = 1e-4;      // of the pseudo-inverse, against the Jacobian's square
constexpr double kLongestStep = 0.35;  // of all joints together: so far the Jacobian holds
constexpr double kSteep = 0.6;         // cosine of the incidence from which on an axis is left as it is
constexpr double kTurning = 0.3;       // share of the way to head on that an axis is turned by in a step
constexpr double kOffRange = 0.98;     // of the sensing range, not to lose the sample by rounding

/// The place on the axis that is to come to the sample.
double along(const Posture::Sensor& sensor, const Vector3d& at, double nearest) {
  return std::clamp((at - sensor.position).dot(sensor.axis), nearest,
                    std::max(nearest, kOffRange * sensor.range));
}

/// Joint changes that move what `jacobian` tells of by `motion`, and else follow `wish` where that is free.
Eigen::VectorXd changes(const Eigen::Matrix3Xd& jacobian, const Vector3d& motion,
                        const Eigen::VectorXd& wish) {
  const Matrix3d square = jacobian * jacobian.transpose();
  const Eigen::LDLT<Matrix3d> solver(square + kDamping * square.trace() * Matrix3d::Identity());
  return wish + jacobian.transpose() * solver.solve(motion - jacobian * wish);
}

/// Turns a sensor's axis towards a direction.
Eigen::VectorXd turning(const Posture& posture, std::size_t link, const Posture::Sensor& sensor,
                        const Vector3d& towards) {
  const Eigen::Matrix3Xd jacobian =
      posture.jacobian(link, sensor.position + sensor.axis) - posture.jacobian(link, sensor.position);
  return changes(jacobian, kTurning * (towards - sensor.axis), Eigen::VectorXd::Zero(jacobian.cols()));
}

Eigen::VectorXd shortened(const Eigen::VectorXd& step) {
  const double length = step.norm();
  return length > kLongestStep ? Eigen::VectorXd(step * (kLongestStep / length)) : step;
}

}  // namespace

bool sees(const Posture::Sensor& sensor, const SurfaceSample& sample, const TrueSurface& truth,
          const SightOptions& options) {
  const Vector3d from_sample = sensor.position - sample.at;
  const double distance = from_sample.norm(), forward = -from_sample.dot(sensor.axis);
  if (!(forward > 0) || distance > sensor.range) return false;
  if (-sensor.axis.dot(sample.normal) < options.least_cosine) return false;
  if ((from_sample + forward * sensor.axis).norm() > options.precision) return false;
  const Vector3d back = from_sample / distance;
  const double lift = 1e-9 * sensor.range;  // off the surface
  const auto crossed = truth.first_crossing(sample.at + lift * back, back);
  return !crossed || *crossed + lift > distance;
}

double misses_by(const Posture::Sensor& sensor, const SurfaceSample& sample, double nearest) {
  const double t = along(sensor, sample.at, nearest), cosine = -sensor.axis.dot(sample.normal);
  return (sensor.position + t * sensor.axis - sample.at).norm() +
         sensor.range * std::max(0.0, kSteep - cosine);
}

std::optional<Configuration> aimed(const ArmSpace& space, Configuration at, std::size_t sensor,
                                   const SurfaceSample& sample, double nearest, const SightOptions& options) {
  const std::size_t link = space.robot().sensors[sensor].link;
  for (int step = 0; step < kSteps; ++step) {
    const Posture posture(space.robot(), at);
    const Posture::Sensor s = posture.sensor(sensor);
    const double t = along(s, sample.at, nearest);
    const Vector3d spot = s.position + t * s.axis, off = sample.at - spot;
    const double cosine = -s.axis.dot(sample.normal);
    if (off.norm() <= options.precision / 2 && cosine >= options.least_cosine) return at;
    Eigen::Matrix3Xd jacobian = posture.jacobian(link, spot);
    const bool slides =
        (sample.at - s.position).dot(s.axis) == t;  // the spot may be anywhere near on the axis
    if (slides) jacobian -= s.axis * (s.axis.transpose() * jacobian);
    Eigen::VectorXd wish = Eigen::VectorXd::Zero(at.size());
    if (cosine < kSteep) wish = turning(posture, link, s, -sample.normal);
    at = space.within_limits(at + shortened(changes(jacobian, off, wish)));
  }
  return std::nullopt;
}

}  // namespace limpet::evaluation
