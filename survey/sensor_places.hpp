// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limpet/model/sensor_point.hpp>
#include <vector>

namespace limpet::survey {

/// The places where the sensors of a scan stood, in the scan's frame and unit, the first reading's first:
/// every reading with a range came from within a thirtieth of that range of one of them. Where that would be
/// more than `most` places, as along the way of a scanner that moves, they are fewer and farther apart.
/// Empty when no reading says its range.
std::vector<Eigen::Vector3d> sensor_places(const std::vector<model::SensorPoint>& readings, std::size_t most);

}  // namespace limpet::survey
