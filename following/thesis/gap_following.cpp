// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <limits>

#include "edges_internal.hpp"
#include "gap_following_internal.hpp"
#include "gap_internal.hpp"

namespace limpet::following::internal {

using Eigen::Vector3d;
using kinematics::Posture;

Vector3d nearest_on_axis(const Posture::Sensor& sensor, const Vector3d& target) {
  return nearest_on(sensor.position, sensor.position + sensor.range * sensor.axis, target);
}

void GapFollowing::begin(const Situation& now, Pursuit& pursuit, const Vector3d& current_point, Mode from) {
  from_ = from;
  targets_ =
      target_points(gap_point(now.view, current_point, *now.closest), current_point, now.half_resolution());
  target_ = 0;
  moved_ = false;
  choose_sensor(now);
  pursuit.progress.restart(now.parameters.sensing_range);
}

Decision GapFollowing::follow(const Situation& now, Pursuit& pursuit) {
  if (is_over(now, pursuit)) return Mode::current_segment;
  if (target_ < targets_.size() && pursuit.progress.is_insufficient()) next(now, pursuit);
  while (target_ < targets_.size() && is_detected(now)) next(now, pursuit);
  if (target_ == targets_.size()) return from_;
  moved_ = true;
  const Vector3d& target = targets_[target_];
  const Vector3d way = target - nearest_on_axis(now.posture.sensor(sensor_), target);
  return Direction{way, way.norm()};
}

std::vector<Vector3d> GapFollowing::targets() const {
  return {targets_.begin() + static_cast<std::ptrdiff_t>(std::min(target_, targets_.size())), targets_.end()};
}

/// Has surface modelling changed the current edge, or made a polygon of the point segment?
bool GapFollowing::is_over(const Situation& now, const Pursuit& pursuit) const {
  if (from_ == Mode::current_edge) return !pursuit.edge;
  const auto segment = now.view.segment(pursuit.segment);
  return !segment || segment->kind != model::View::Kind::point;
}

bool GapFollowing::is_detected(const Situation& now) const {
  return std::any_of(now.readings.begin(), now.readings.end(), [&](const model::SensorPoint& p) {
    return (p.position - targets_[target_]).norm() < now.half_resolution();
  });
}

void GapFollowing::next(const Situation& now, Pursuit& pursuit) {
  ++target_;
  if (target_ < targets_.size()) choose_sensor(now);
  pursuit.progress.restart(now.parameters.sensing_range);
}

void GapFollowing::choose_sensor(const Situation& now) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < now.posture.robot().sensors.size(); ++i) {
    const Vector3d on_axis = nearest_on_axis(now.posture.sensor(i), targets_[target_]);
    const double d = (on_axis - targets_[target_]).norm();
    if (d < least) least = d, sensor_ = i;
  }
}

}  // namespace limpet::following::internal
