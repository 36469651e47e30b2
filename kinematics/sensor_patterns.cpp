// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/kinematics/sensor_patterns.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace limpet::kinematics {
namespace {

using Eigen::Vector3d;

constexpr double kSamePlace = 1e-9;    // between origins: nearer is rounding
constexpr double kMostRings = 10'000;  // on one capsule: more is a slip of the pen

void require_pattern(bool good, const std::string& what) {
  if (!good) throw std::invalid_argument(what);
}

void require_common(const Vector3d& place, double range) {
  require_pattern(place.allFinite(), "the place of sensors must be finite");
  require_pattern(range > 0 && std::isfinite(range), "the range of sensors must be a number more than 0");
}

Vector3d unit_direction(const Vector3d& v, const std::string& what) {
  require_pattern(v.allFinite() && v.norm() > 0, what + " must be a finite vector that is not zero");
  return v.normalized();
}

/// A unit vector orthogonal to a unit vector: the coordinate axis that is least along it, made orthogonal.
Vector3d first_outwards(const Vector3d& axis) {
  Eigen::Index least = 0;
  axis.cwiseAbs().minCoeff(&least);
  const Vector3d unit = Vector3d::Unit(least);
  return (unit - unit.dot(axis) * axis).normalized();
}

bool is_inside(const Vector3d& p, const model::Capsule& capsule) {
  const Vector3d along = capsule.b - capsule.a;
  const double length2 = along.squaredNorm();
  const double share = length2 > 0 ? std::clamp((p - capsule.a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (p - capsule.a - share * along).norm() < capsule.radius;
}

/// From the control point to the nearest other origin of the links that it is rigid with, the last joint that
/// moves among them; in the frame of its link. None: it is in that joint itself.
std::optional<Vector3d> way_back(const Robot& robot) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  // of a link, in the control point's link
  for (std::size_t i = robot.control_point.link;;) {
    Vector3d back = pose.translation() - robot.control_point.position;
    if (back.norm() > kSamePlace) return back;
    const Link& link = robot.links[i];
    if (link.joint.kind != Joint::Kind::fixed || !link.parent) return std::nullopt;
    pose = pose * link.mounting.inverse();
    i = *link.parent;
  }
}

/// Position i of n ones in a row from -1/2 to 1/2; a single one is in the middle.
double place_in_row(std::size_t i, std::size_t n) {
  return n == 1 ? 0 : static_cast<double>(i) / static_cast<double>(n - 1) - 0.5;
}

}  // namespace

std::vector<RangeSensor> ring(const Ring& ring) {
  require_common(ring.centre, ring.range);
  const Vector3d axis = unit_direction(ring.axis, "the axis of a ring"), u = first_outwards(axis),
                 v = axis.cross(u);
  require_pattern(ring.radius >= 0 && std::isfinite(ring.radius), "the radius of a ring must be 0 or more");
  require_pattern(ring.count > 0, "a ring must have a sensor");
  require_pattern(std::isfinite(ring.tilt_rad) && std::isfinite(ring.turn_rad),
                  "the angles of a ring must be finite");
  std::vector<RangeSensor> sensors;
  const double step = 2 * std::numbers::pi / static_cast<double>(ring.count);
  for (std::size_t i = 0; i < ring.count; ++i) {
    const double angle = ring.turn_rad + static_cast<double>(i) * step;
    const Vector3d outwards = std::cos(angle) * u + std::sin(angle) * v;
    const Vector3d sensing = std::cos(ring.tilt_rad) * outwards + std::sin(ring.tilt_rad) * axis;
    sensors.push_back({ring.link, ring.centre + ring.radius * outwards, sensing.normalized(), ring.range});
  }
  return sensors;
}

std::vector<RangeSensor> rings(const Rings& rings) {
  require_pattern(rings.rings > 0, "there must be a ring");
  require_pattern(rings.from.allFinite() && rings.to.allFinite(), "the ends of rings must be finite");
  const Vector3d along = rings.to - rings.from;
  require_pattern(along.norm() > 0, "the first and the last of rings must not be in one place");
  require_pattern(rings.count > 0, "a ring must have a sensor");
  std::vector<RangeSensor> sensors;
  for (std::size_t i = 0; i < rings.rings; ++i) {
    Ring one{rings.link,  rings.from + (place_in_row(i, rings.rings) + 0.5) * along,
             along,       rings.radius,
             rings.count, rings.tilt_rad,
             0,           rings.range};
    if (rings.staggered && i % 2 == 1) one.turn_rad = std::numbers::pi / static_cast<double>(rings.count);
    const std::vector<RangeSensor> more = ring(one);
    sensors.insert(sensors.end(), more.begin(), more.end());
  }
  return sensors;
}

std::vector<RangeSensor> patch(const Patch& patch) {
  require_common(patch.centre, patch.range);
  const Vector3d u = unit_direction(patch.along, "a side of a patch");
  const Vector3d v = unit_direction(patch.across, "a side of a patch");
  require_pattern(std::abs(u.dot(v)) < 1e-6, "the sides of a patch must be orthogonal");
  require_pattern(patch.columns > 0 && patch.rows > 0, "a patch must have a sensor");
  const Vector3d axis = u.cross(v).normalized();
  std::vector<RangeSensor> sensors;
  for (std::size_t row = 0; row < patch.rows; ++row)
    for (std::size_t column = 0; column < patch.columns; ++column) {
      const Vector3d place = patch.centre + place_in_row(column, patch.columns) * patch.along +
                             place_in_row(row, patch.rows) * patch.across;
      sensors.push_back({patch.link, place, axis, patch.range});
    }
  return sensors;
}

std::vector<RangeSensor> ball(const Ball& ball) {
  require_common(ball.centre, ball.range);
  std::optional<Vector3d> without;
  if (ball.without) without = unit_direction(*ball.without, "the axis of the cone that is left out");
  require_pattern(std::isfinite(ball.without_rad), "the angle of the cone that is left out must be finite");
  std::vector<RangeSensor> sensors;
  for (int corners = 1; corners <= 3; ++corners)  // how many coordinates are not 0: faces, edges, corners
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z) {
          if (std::abs(x) + std::abs(y) + std::abs(z) != corners) continue;
          const Vector3d axis = Vector3d(x, y, z).normalized();
          if (!without || axis.dot(*without) < std::cos(ball.without_rad))
            sensors.push_back({ball.link, ball.centre, axis, ball.range});
        }
  return sensors;
}

namespace {

std::size_t count_around(const model::Capsule& part, const Skin& skin) {
  constexpr double kFewest = 4, kBetween = 1.35, kInFront = 0.6;  // spacings
  if (skin.count > 0) return skin.count;
  const double around = 2 * std::numbers::pi * (part.radius / skin.spacing + kInFront) / kBetween;
  require_pattern(around < kMostRings, "the spacing of a skin is too small for its link");
  return static_cast<std::size_t>(std::max(kFewest, std::ceil(around)));
}

}  // namespace

std::vector<RangeSensor> skin(const Robot& robot, const Skin& skin) {
  require_pattern(skin.link < robot.links.size(), "a skin must be on a link");
  require_pattern(skin.spacing > 0, "the spacing of a skin must be more than 0");
  const std::vector<model::Capsule>& body = robot.links[skin.link].body;
  std::vector<RangeSensor> sensors;
  for (const model::Capsule& part : body) {
    const double length = (part.b - part.a).norm();
    require_pattern(length / skin.spacing < kMostRings, "the spacing of a skin is too small for its link");
    const auto steps = static_cast<std::size_t>(std::ceil(length / skin.spacing));
    const std::size_t count = count_around(part, skin);
    const std::vector<RangeSensor> more =
        length > 0 ? rings({skin.link, part.a, part.b, steps + 1, part.radius, count, 0, true, skin.range})
                   : ring({skin.link, part.a, Vector3d::UnitZ(), part.radius, count, 0, 0, skin.range});
    for (const RangeSensor& sensor : more) {
      const auto hides = [&](const model::Capsule& other) {
        return &other != &part && is_inside(sensor.position, other);
      };
      if (std::none_of(body.begin(), body.end(), hides)) sensors.push_back(sensor);
    }
  }
  return sensors;
}

std::vector<RangeSensor> usual_sensors(const Robot& robot, double range) {
  const ControlPoint& at = robot.control_point;
  std::vector<RangeSensor> sensors =
      ball({.link = at.link, .centre = at.position, .without = way_back(robot), .range = range});
  std::vector<bool> is_moved(robot.links.size());
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const Link& link = robot.links[i];
    is_moved[i] = link.joint.kind != Joint::Kind::fixed || (link.parent && is_moved[*link.parent]);
    if (!is_moved[i]) continue;
    const std::vector<RangeSensor> more = skin(robot, {.link = i, .spacing = range / 2, .range = range});
    sensors.insert(sensors.end(), more.begin(), more.end());
  }
  return sensors;
}

}  // namespace limpet::kinematics
