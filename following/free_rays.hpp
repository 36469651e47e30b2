// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/kinematics/posture.hpp>
#include <limpet/model/sensor_point.hpp>
#include <span>

namespace limpet::following {

/// The distance up to which the ray of a sensor (world) is known to be free: its range, or where it has read
/// something. A reading of the set is the sensor's that has its axis and is on it, or beside it by less than
/// `beside` (scan's unit): the point that a range image has there.
double free_range(const kinematics::Posture::Sensor& sensor, std::span<const model::SensorPoint> set,
                  double beside);

}  // namespace limpet::following
