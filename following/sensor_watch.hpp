// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace limpet::following {

/// Finds sensors that are stuck: that say the same distance wherever the robot is. What they say would be
/// modelled as a surface that goes with the robot, and followed without end.
///
///     SensorWatch watch(resolution, robot.sensors.size());
///     const bool stuck = watch.is_stuck(sensor, posture.sensor(sensor).position, distance);
///     if (distance && !stuck) readings.push_back(posture.sensor_point(sensor, *distance));
///
/// A surface can give the same distance again and again, but only at places of the sensor that lie in a
/// plane. So a sensor is stuck when the places at which it has said one distance, in one set after the other,
/// spread by λ/2 (standard deviation) in every direction of space: more than the next of parallel planes is
/// off.
class SensorWatch {
 public:
  /// Throws std::invalid_argument unless the resolution λ is positive.
  SensorWatch(double resolution, std::size_t sensors);

  /// Takes what a sensor at this position (world) says, or that it says nothing. Returns whether it is stuck;
  /// once it is, it stays so. Precondition: sensor < sensors.
  bool is_stuck(std::size_t sensor, const Eigen::Vector3d& position, std::optional<double> distance);

  /// The sensors that are stuck, ascending.
  std::vector<std::size_t> stuck() const;

 private:
  struct Record {
    std::optional<double> distance;                    ///< the last one
    double count = 0;                                  ///< of sets with it
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();    ///< of the sensor's positions then
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();  ///< Σ (position − mean)(position − mean)ᵀ
    bool stuck = false;
  };
  double least_spread_;
  std::vector<Record> records_;  ///< by sensor
};

}  // namespace limpet::following
