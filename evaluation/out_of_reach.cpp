// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <cmath>
#include <limpet/evaluation/out_of_reach_internal.hpp>

namespace limpet::evaluation {

using Eigen::Vector3d;
using kinematics::Robot;

bool is_at_control_point(const Robot& robot, std::size_t sensor) {
  const kinematics::RangeSensor& s = robot.sensors[sensor];
  return s.link == robot.control_point.link &&
         (s.position - robot.control_point.position).norm() < 1e-9 * s.range;
}

OutOfReach::OutOfReach(const simulation::Mesh& mesh, const TrueSurface& truth,
                       const kinematics::Posture& start, double clearance) {
  const Robot& robot = start.robot();
  bool all_at_control_point = true;
  for (std::size_t i = 0; i < robot.sensors.size(); ++i) {
    const kinematics::RangeSensor& sensor = robot.sensors[i];
    ReachBall ball = reach_of_point(robot, sensor.link, sensor.position);
    ball.radius += sensor.range;
    const auto holds_it = [&](const ReachBall& other) {
      return other.centre == ball.centre && other.radius >= ball.radius;
    };
    if (std::none_of(balls_.begin(), balls_.end(), holds_it)) balls_.push_back(ball);
    range_ = std::max(range_, sensor.range);
    all_at_control_point &= is_at_control_point(robot, i);
  }
  if (!all_at_control_point) return;
  FreeSpaceOptions options;
  options.start = start.control_point();
  options.clearance = clearance;
  options.margin = range_;
  space_.emplace(truth, simulation::bounds_of(mesh), options);
}

bool OutOfReach::holds(const SurfaceSample& sample) const {
  const auto is_beyond = [&](const ReachBall& ball) {
    return (sample.at - ball.centre).norm() > ball.radius * (1 + 1e-9);
  };
  return std::all_of(balls_.begin(), balls_.end(), is_beyond) || (space_ && is_enclosed(sample));
}

/// Looks at each cell of the lattice that is within range in front of the sample.
bool OutOfReach::is_enclosed(const SurfaceSample& sample) const {
  const double pitch = space_->pitch(), diagonal = std::sqrt(3.0) * pitch, far = range_ + diagonal;
  const int count = static_cast<int>(std::ceil(far / pitch));
  for (int x = -count; x <= count; ++x)
    for (int y = -count; y <= count; ++y)
      for (int z = -count; z <= count; ++z) {
        const Vector3d away = pitch * Vector3d(x, y, z);
        if (away.norm() > far || away.dot(sample.normal) < -diagonal) continue;
        if (space_->ruled_out(sample.at + away, Vector3d::UnitX()) == 0) return false;
      }
  return true;
}

}  // namespace limpet::evaluation
