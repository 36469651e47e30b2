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
/// A plane can give the same distance again and again, but only at places of the sensor that lie in a plane;
/// several planes, at places that lie in several. So four places in a row that do not lie in a plane, at
/// which a sensor says one distance, are a turn from one plane to another, or a sensor that is stuck; and one
/// that says the same distance through 16 of them, in one set after the other, is stuck.
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
    std::optional<double> distance;       ///< the last one
    std::vector<Eigen::Vector3d> places;  ///< of the sensor at the last sets with it, up to four
    int off_plane = 0;                    ///< sets with it at which the last four did not lie in a plane
    bool stuck = false;
  };

  double least_volume_;
  std::vector<Record> records_;  ///< by sensor
};

}  // namespace limpet::following
