// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/following/links/goal_postures.hpp>

#include <algorithm>
#include <numbers>

#include "clear_goals_internal.hpp"

namespace limpet::following {
namespace {

using Eigen::Vector3d;
using internal::Wish;
using kinematics::Configuration;
using kinematics::Posture;
using kinematics::Robot;

/// Looking at a place with a robot's sensors.
class Look {
 public:
  Look(const LinkMotion& links, const Suspicion& suspicion, Sight sight)
      : links_(links), suspicion_(suspicion), is_sure_(sight == Sight::sure) {}

  Wish with(std::size_t sensor) const {
    return {[this, sensor](const Posture& posture) { return task(posture, sensor); },
            [this, sensor](const Posture& posture) { return miss(posture.sensor(sensor)); },
            [this, sensor](const Posture& posture) { return sees(posture.sensor(sensor)); }};
  }

 private:
  /// The point on the sensor's axis that is to be brought to the place: the nearest of those at which
  /// something would be met, and from which the sensor is not too near to it.
  Vector3d point_of(const Posture::Sensor& sensor) const {
    constexpr double kSurelyBeyond = 0.7, kBeyond = 0.1;  // λ
    const LinkParameters& p = links_.parameters();
    const double beyond = (is_sure_ ? kSurelyBeyond : kBeyond) * p.resolution;
    const double nearest = p.control_clearance, farthest = sensor.range - beyond;
    const double along = (suspicion_.at - sensor.position).dot(sensor.axis);
    return sensor.position + std::clamp(along, std::min(nearest, farthest), farthest) * sensor.axis;
  }

  Task task(const Posture& posture, std::size_t sensor) const {
    const Vector3d point = point_of(posture.sensor(sensor));
    return {suspicion_.at - point, posture.jacobian(posture.robot().sensors[sensor].link, point)};
  }

  /// How far the sensor looks past the place; more for one that looks from behind or along the surface.
  double miss(const Posture::Sensor& sensor) const {
    constexpr double kFrontal = 0.5;
    const double turned = std::max(0.0, kFrontal + sensor.axis.dot(suspicion_.normal));
    return (suspicion_.at - point_of(sensor)).norm() + turned * sensor.range;
  }

  bool sees(const Posture::Sensor& sensor) const {
    constexpr double kSure = 0.26, kFaint = 0.1;  // cosines of 75° and 84°
    if (-sensor.axis.dot(suspicion_.normal) < (is_sure_ ? kSure : kFaint)) return false;
    const Vector3d way = suspicion_.at - sensor.position;
    const double free = way.norm() - links_.parameters().resolution / 2;
    return free <= 0 || !links_.obstacles().view().first_hit(sensor.position, way, free);
  }

  const LinkMotion& links_;
  const Suspicion& suspicion_;
  bool is_sure_;
};

}  // namespace

Configuration spread_over(const Robot& robot, const Eigen::VectorXd& unit) {
  Configuration at = unit;
  kinematics::for_each_moving_joint(robot, [&](Eigen::Index k, const kinematics::Joint& joint) {
    const double low = std::max(joint.low, -std::numbers::pi);
    at[k] = low + unit[k] * (std::min(joint.high, std::numbers::pi) - low);
  });
  return at;
}

std::vector<Configuration> goal_postures(LinkMotion& links, const Roadmap& roadmap, const Vector3d& place) {
  const Wish there{
      [&](const Posture& posture) { return control_point_task(posture, place - posture.control_point()); },
      [&](const Posture& posture) { return (place - posture.control_point()).norm(); },
      {}};
  return internal::clear_goals(links, roadmap, place, {there});
}

std::vector<Configuration> sighting_postures(LinkMotion& links, const Roadmap& roadmap,
                                             const Suspicion& suspicion, Sight sight,
                                             std::span<const std::size_t> sensors) {
  const Look look(links, suspicion, sight);
  std::vector<Wish> wishes;
  for (const std::size_t sensor : sensors) wishes.push_back(look.with(sensor));
  return internal::clear_goals(links, roadmap, suspicion.at, wishes);
}

}  // namespace limpet::following
