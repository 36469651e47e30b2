// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/evaluation/free_space.hpp>
#include <limpet/evaluation/joint_levers_internal.hpp>
#include <limpet/evaluation/reachable.hpp>
#include <limpet/kinematics/posture.hpp>
#include <optional>
#include <vector>

namespace limpet::evaluation {

/// What samples of the surface no configuration of a robot can see: those beyond the balls that its sensors
/// never leave, and the sensing range; and, if all sensors are at the control point, those within range of no
/// place that a point robot gets to from the start.
class OutOfReach {
 public:
  /// `clearance`: of the control point, > 0. Keeps a reference to the surface.
  OutOfReach(const simulation::Mesh&, const TrueSurface&, const kinematics::Posture& start, double clearance);

  bool holds(const SurfaceSample&) const;

 private:
  bool is_enclosed(const SurfaceSample&) const;

  std::vector<ReachBall> balls_;  ///< with the sensing range
  double range_ = 0;              ///< the largest
  std::optional<FreeSpace> space_;
};

/// Is a sensor at the control point?
bool is_at_control_point(const kinematics::Robot&, std::size_t sensor);

}  // namespace limpet::evaluation
