// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <span>
#include <variant>

#include <limpet/following/follower.hpp>
#include <limpet/following/parameters.hpp>
#include <limpet/kinematics/posture.hpp>
#include <limpet/model/model.hpp>
#include <limpet/model/view.hpp>

namespace limpet::following::internal {

/// What a motion mode may look at: the model after the last set, and where the control point is.
struct Situation {
  const Parameters& parameters;
  const model::Model& model;
  model::View view;
  const kinematics::Posture& posture;
  std::span<const model::SensorPoint> readings;
  Eigen::Vector3d at;                           ///< the control point, world
  std::optional<model::View::Nearest> closest;  ///< closest surface model point; none: the model is empty

  /// Width of a slice, and distance between target points (thesis §3.4.3, §3.4.5).
  double half_resolution() const { return parameters.resolution / 2; }
};

/// A surface following direction: world frame, of any length; with the longest step that may follow.
struct Direction {
  Eigen::Vector3d along = Eigen::Vector3d::Zero();
  double step_limit = std::numeric_limits<double>::infinity();
};

/// What a motion mode decides: a direction, another mode to go on with (Figure 38), or the end of the run.
using Decision = std::variant<Direction, Mode, End>;

}  // namespace limpet::following::internal
