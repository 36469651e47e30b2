// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <cmath>
#include <limpet/drawing/robot_figure.hpp>

namespace limpet::drawing {
namespace {

using Eigen::Vector3d;
using kinematics::Posture;

void add_links(const Posture& posture, RobotFigure& figure) {
  const auto& links = posture.robot().links;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Eigen::Isometry3d& pose = posture.link(i);
    for (const model::Capsule& part : links[i].body) {
      const model::Capsule placed{pose * part.a, pose * part.b, part.radius};
      if (part.radius > 0)
        figure.body.push_back(placed);
      else
        figure.bones.push_back({placed.a, placed.b});
    }
    if (!links[i].parent || links[i].joint.kind == kinematics::Joint::Kind::prismatic) continue;
    const Vector3d from = posture.link(*links[i].parent).translation(), to = pose.translation();
    if (links[*links[i].parent].body.empty() && from != to) figure.bones.push_back({from, to});
  }
}

void add_rays(const Posture& posture, const simulation::Sensed& sensed, double endless, RobotFigure& figure) {
  std::vector<bool> met(posture.robot().sensors.size());
  for (std::size_t i = 0; i < sensed.points.size(); ++i) {
    met[sensed.sensors[i]] = true;
    figure.rays.push_back({posture.sensor(sensed.sensors[i]).position, sensed.points[i].position});
  }
  for (std::size_t i = 0; i < met.size(); ++i) {
    if (met[i]) continue;
    const Posture::Sensor sensor = posture.sensor(i);
    const double range = std::isfinite(sensor.range) ? sensor.range : endless;
    figure.misses.push_back({sensor.position, sensor.position + range / 2 * sensor.axis});
  }
}

void add_switches(const Posture& posture, const simulation::Sensed& sensed, RobotFigure& figure) {
  for (std::size_t i = 0; i < posture.robot().switches.size(); ++i) {
    const Posture::Switch s = posture.proximity_switch(i);
    if (std::binary_search(sensed.seeing.begin(), sensed.seeing.end(), i))
      figure.fields.push_back({s.position, s.position + s.range * s.axis});
    else
      figure.quiet.push_back(s.position);
  }
}

}  // namespace

RobotFigure robot_figure(const Posture& posture, const simulation::Sensed& sensed, double endless) {
  RobotFigure figure;
  add_links(posture, figure);
  add_rays(posture, sensed, endless, figure);
  add_switches(posture, sensed, figure);
  return figure;
}

}  // namespace limpet::drawing
