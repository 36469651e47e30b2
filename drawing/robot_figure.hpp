// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/kinematics/posture.hpp>
#include <limpet/model/view.hpp>
#include <limpet/simulation/sensing.hpp>
#include <vector>

namespace limpet::drawing {

/// A robot at one moment, as it is drawn; world.
struct RobotFigure {
  struct Line {
    Eigen::Vector3d from, to;
  };
  std::vector<model::Capsule> body;
  std::vector<Line> bones;             ///< between joints that nothing with extent joins
  std::vector<Line> rays;              ///< from sensors to what they met
  std::vector<Line> misses;            ///< of sensors that met nothing, along half of their range
  std::vector<Eigen::Vector3d> quiet;  ///< proximity switches that see nothing
  std::vector<Line> fields;            ///< of switches that see something: from the switch through its field

  bool has_body() const { return !body.empty() || !bones.empty(); }
};

/// The robot as a set was sensed: `sensed` is of the posture, and with the posture's robot. Links without
/// extent become bones, but for gantries: prismatic joints that nothing with extent carries are only numbers.
/// Where a sensing range is infinite, `endless` stands for it (scan's unit).
RobotFigure robot_figure(const kinematics::Posture&, const simulation::Sensed& sensed, double endless);

}  // namespace limpet::drawing
