// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstddef>
#include <limpet/kinematics/posture.hpp>
#include <limpet/model/model.hpp>
#include <span>

namespace limpet::following {

/// What a follower is told after each set.
struct Observation {
  const model::Model& model;                     ///< has taken in the readings
  std::span<const model::Change> changes;        ///< what they did to it
  const kinematics::Posture& posture;            ///< where the robot is, as far as it knows
  std::span<const model::SensorPoint> readings;  ///< the last set
  std::span<const std::size_t> seeing = {};      ///< the proximity switches that see something; ascending
};

}  // namespace limpet::following
