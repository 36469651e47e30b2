// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/simulation/sensing.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace limpet::simulation {
namespace {

using Eigen::Vector3d;
using kinematics::Configuration;
using kinematics::Joint;
using kinematics::Posture;
using kinematics::Robot;

void require_not_negative(double value, const char* name) {
  if (!(value >= 0 && std::isfinite(value))) throw std::invalid_argument(std::string(name) + " is below 0");
}

void require_fraction(double value, const char* name) {
  if (!(value >= 0 && value <= 1))
    throw std::invalid_argument(std::string("a fraction of ") + name + " is between 0 and 1");
}

/// 1 + k·tan²θ, bounded.
double growth_at_angle(double k, double cosine) {
  const double cosine2 = std::min(1.0, cosine * cosine);
  if (cosine <= 0 || k * (1 - cosine2) >= (kMostGrazingNoise - 1) * cosine2) {
    return k > 0 ? kMostGrazingNoise : 1;
  }
  return 1 + k * (1 - cosine2) / cosine2;
}

}  // namespace

kinematics::Configuration moved(const SensingErrors& errors, kinematics::Configuration changes,
                                std::int64_t set) {
  for (const SensingErrors::StuckJoint& stuck : errors.stuck_joints)
    if (set >= stuck.set) changes[static_cast<Eigen::Index>(stuck.joint)] = 0;
  return changes;
}

void require_sound(const SensingErrors& errors) {
  require_not_negative(errors.noise, "the noise of readings");
  require_not_negative(errors.noise_at_angle, "the growth of noise with the angle");
  require_not_negative(errors.encoder_noise, "the noise of prismatic encoders");
  require_not_negative(errors.encoder_noise_rad, "the noise of revolute encoders");
  require_fraction(errors.dropouts, "dropouts");
  require_fraction(errors.outliers, "outliers");
  for (const SensingErrors::Stuck& stuck : errors.stuck)
    require_not_negative(stuck.distance, "the distance that a stuck sensor says");
}

/// What one sensor draws in one step.
struct Sensing::Luck {
  bool lost = false, outlier = false;
  double anywhere = 0;  ///< of the range, 0 to 1
  double normal = 0;
};

Sensing::Luck Sensing::draw() {
  Luck luck;
  luck.lost = sensor_luck_.uniform() < errors_.dropouts;
  luck.outlier = sensor_luck_.uniform() < errors_.outliers;
  luck.anywhere = sensor_luck_.uniform();
  luck.normal = sensor_luck_.normal();
  return luck;
}

Sensing::Sensing(const World& world, const SensingErrors& errors)
    : world_(world),
      errors_(errors),
      encoder_luck_(errors.seed ^ 0x656e636f64657273u),
      sensor_luck_(errors.seed) {
  require_sound(errors);
}

Configuration Sensing::measure(const Robot& robot, const Configuration& truth) {
  Configuration measured = truth;
  kinematics::for_each_moving_joint(robot, [&](Eigen::Index k, const Joint& joint) {
    const bool slides = joint.kind == Joint::Kind::prismatic;
    measured[k] += (slides ? errors_.encoder_noise : errors_.encoder_noise_rad) * encoder_luck_.normal();
  });
  return measured;
}

std::optional<World::Sighting> Sensing::read(const Posture& truth, std::size_t i, const Luck& luck) const {
  const auto stuck = std::find_if(errors_.stuck.begin(), errors_.stuck.end(),
                                  [i](const SensingErrors::Stuck& s) { return s.sensor == i; });
  if (stuck != errors_.stuck.end()) return World::Sighting{stuck->distance};
  const Posture::Sensor sensor = truth.sensor(i);
  auto seen = world_.sight(sensor.position, sensor.axis, sensor.range);
  if (!seen || luck.lost) return std::nullopt;
  if (luck.outlier) return World::Sighting{luck.anywhere * sensor.range};
  const double sigma = errors_.noise * growth_at_angle(errors_.noise_at_angle, seen->incidence_cosine);
  seen->distance = std::max(0.0, seen->distance + sigma * luck.normal);
  return seen;
}

Sensed Sensing::sense(const Robot& robot, const Configuration& true_configuration) {
  const Posture truth(robot, true_configuration);
  for (const SensingErrors::Stuck& stuck : errors_.stuck)
    if (stuck.sensor >= robot.sensors.size())
      throw std::invalid_argument("there is no sensor " + std::to_string(stuck.sensor) + " to be stuck");
  Sensed sensed;
  sensed.measured = measure(robot, true_configuration);
  const Posture believed(robot, sensed.measured);
  for (std::size_t i = 0; i < robot.sensors.size(); ++i) {
    const Luck luck = draw();
    const auto reading = read(truth, i, luck);
    if (!reading) continue;
    const std::size_t link = robot.sensors[i].link;
    model::SensorPoint point = believed.sensor_point(i, reading->distance);
    point.position += believed.link(link).linear() * (truth.link(link).linear().transpose() * reading->aside);
    sensed.points.push_back(point);
    sensed.sensors.push_back(i);
  }
  for (std::size_t i = 0; i < robot.switches.size(); ++i) {
    const Posture::Switch s = truth.proximity_switch(i);
    if (world_.meets(s.field_centre, s.range / 2)) sensed.seeing.push_back(i);
  }
  return sensed;
}

}  // namespace limpet::simulation
