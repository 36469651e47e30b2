// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <limpet/kinematics/posture.hpp>
#include <limpet/simulation/world.hpp>
#include <limpet/survey/random.hpp>
#include <vector>

namespace limpet::simulation {

/// The most that grazing incidence multiplies the noise by.
inline constexpr double kMostGrazingNoise = 10;

/// What is wrong with a robot's range sensors, joint encoders and actuators. As it stands: nothing.
struct SensingErrors {
  /// σ: standard deviation of a reading along its axis where it meets the surface head on; scan's unit, ≥ 0.
  double noise = 0;
  /// k, ≥ 0: at an angle θ of incidence the standard deviation is σ·(1 + k·tan²θ), at most
  /// kMostGrazingNoise·σ. (The infra-red sensors of thesis §4.2 were useless at an angle.)
  double noise_at_angle = 0;
  double dropouts = 0;  ///< fraction of the readings that are lost, 0 to 1
  double outliers = 0;  ///< fraction of the readings that are replaced by one anywhere within range, 0 to 1

  /// A sensor that always says the same, whatever is there.
  struct Stuck {
    std::size_t sensor = 0;
    double distance = 0;  ///< ≥ 0; it may be beyond the range
  };
  std::vector<Stuck> stuck = {};

  /// A joint that moves no more, whatever it is told, from a set on. Its encoder says where it is.
  struct StuckJoint {
    std::size_t joint = 0;
    std::int64_t set = 0;  ///< counted from 0
  };
  std::vector<StuckJoint> stuck_joints = {};

  /// Standard deviation of the measured positions of prismatic joints (scan's unit), and of revolute ones.
  double encoder_noise = 0, encoder_noise_rad = 0;
  std::uint64_t seed = 1;
};

/// What becomes of changes of the joints that the robot is told after a set. Precondition: they are of the
/// robot, and stuck joints are its joints.
kinematics::Configuration moved(const SensingErrors&, kinematics::Configuration changes, std::int64_t set);

/// Throws std::invalid_argument, in one line, when a standard deviation is negative or a fraction is not from
/// 0 to 1.
void require_sound(const SensingErrors&);

/// What a robot learns in one step.
struct Sensed {
  kinematics::Configuration measured;  ///< what its encoders say
  /// The set: one point for each sensor that gave a reading, placed by the measured configuration.
  std::vector<model::SensorPoint> points;
  std::vector<std::size_t> sensors;  ///< of each point, its sensor; ascending
  std::vector<std::size_t> seeing;  ///< the switches that have some of the surface in their fields; ascending
};

/// Senses a world with a robot's range sensors (thesis §4.2) and proximity switches (appendix B), and its
/// joints with their encoders.
///
///  (1) without errors the points are those of the surface, to rounding, and the measured configuration is
///      the true one;
///  (2) each step takes the same random numbers for each joint and sensor, whether or not it finds anything
///      and whatever the errors are: the same seed gives the same errors on another way through the world,
///      and one kind of error does not change another;
///  (3) a noisy reading may be beyond the sensing range; none is below 0;
///  (4) proximity switches make no errors and take no random numbers.
class Sensing {
 public:
  /// The world must outlive it. Throws std::invalid_argument when the errors are not sound.
  Sensing(const World&, const SensingErrors&);

  /// The next step's. The world is sensed where the robot truly is. Throws std::invalid_argument when the
  /// configuration does not fit the robot, or a stuck sensor is none of its sensors.
  Sensed sense(const kinematics::Robot&, const kinematics::Configuration& true_configuration);

 private:
  struct Luck;
  Luck draw();
  kinematics::Configuration measure(const kinematics::Robot&, const kinematics::Configuration&);
  std::optional<World::Sighting> read(const kinematics::Posture& truth, std::size_t sensor,
                                      const Luck&) const;

  const World& world_;
  SensingErrors errors_;
  survey::Random encoder_luck_, sensor_luck_;
};

}  // namespace limpet::simulation
