// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/kinematics/body.hpp>

#include <algorithm>
#include <cmath>

namespace limpet::kinematics {
namespace {

using Eigen::Vector3d;

/// What of the capsule's axis is outside the ball: none, one or two pieces.
std::vector<model::Capsule> outside_ball(const model::Capsule& capsule, const Vector3d& centre,
                                         double radius) {
  const Vector3d along = capsule.b - capsule.a, from_centre = capsule.a - centre;
  const double a = along.squaredNorm(), half_b = along.dot(from_centre);
  const double c = from_centre.squaredNorm() - radius * radius;
  const double discriminant = half_b * half_b - a * c;
  if (!(radius > 0) || (a == 0 ? c >= 0 : discriminant <= 0)) return {capsule};
  if (a == 0) return {};
  const double root = std::sqrt(discriminant), enters = (-half_b - root) / a, leaves = (-half_b + root) / a;
  if (enters >= 1 || leaves <= 0) return {capsule};
  std::vector<model::Capsule> pieces;
  if (enters > 0) pieces.push_back({capsule.a, capsule.a + enters * along, capsule.radius});
  if (leaves < 1) pieces.push_back({capsule.a + leaves * along, capsule.b, capsule.radius});
  return pieces;
}

/// The first link of the rigid body that this one is part of: links with fixed joints between them are one.
std::size_t body_of(const Robot& robot, std::size_t link) {
  while (robot.links[link].joint.kind == Joint::Kind::fixed && robot.links[link].parent)
    link = *robot.links[link].parent;
  return link;
}

bool has_extent(const Robot& robot, std::size_t body) {
  for (std::size_t i = body; i < robot.links.size(); ++i)
    if (!robot.links[i].body.empty() && body_of(robot, i) == body) return true;
  return false;
}

/// The nearest body with extent that carries this one.
std::optional<std::size_t> carrier_of(const Robot& robot, std::size_t body) {
  while (const auto parent = robot.links[body].parent) {
    body = body_of(robot, *parent);
    if (has_extent(robot, body)) return body;
  }
  return std::nullopt;
}

bool are_joined(const Robot& robot, std::size_t link, std::size_t other) {
  const std::size_t a = body_of(robot, link), b = body_of(robot, other);
  return a == b || carrier_of(robot, a) == b || carrier_of(robot, b) == a;
}

Configuration resting(const Robot& robot) {
  return within_limits(robot, Configuration::Zero(static_cast<Eigen::Index>(robot.joint_count())));
}

}  // namespace

bool is_moved(const Robot& robot, std::size_t link) {
  for (std::optional<std::size_t> i = link; i; i = robot.links[*i].parent)
    if (robot.links[*i].joint.kind != Joint::Kind::fixed) return true;
  return false;
}

std::vector<BodyPart> moving_body(const Robot& robot, double spared) {
  std::vector<BodyPart> parts;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (!is_moved(robot, i)) continue;
    for (const model::Capsule& capsule : robot.links[i].body) {
      if (i != robot.control_point.link)
        parts.push_back({i, capsule});
      else
        for (const model::Capsule& piece : outside_ball(capsule, robot.control_point.position, spared))
          parts.push_back({i, piece});
    }
  }
  return parts;
}

model::Capsule in_world(const BodyPart& part, const Posture& posture) {
  const Eigen::Isometry3d& link = posture.link(part.link);
  return {link * part.capsule.a, link * part.capsule.b, part.capsule.radius};
}

Eigen::VectorXd reach_of_joints(const BodyPart& part, const Posture& posture) {
  const Robot& robot = posture.robot();
  std::vector<bool> carries(robot.links.size());
  for (std::optional<std::size_t> i = part.link; i; i = robot.links[*i].parent) carries[*i] = true;
  const model::Capsule world = in_world(part, posture);
  Eigen::VectorXd reach = Eigen::VectorXd::Zero(posture.configuration().size());
  Eigen::Index joint = 0;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const Joint& kind = robot.links[i].joint;
    if (kind.kind == Joint::Kind::fixed) continue;
    const Eigen::Index column = joint++;
    if (!carries[i]) continue;
    const Vector3d axis = posture.link(i).linear() * kind.axis, at = posture.link(i).translation();
    const auto from_axis = [&](const Vector3d& p) { return axis.cross(p - at).norm(); };
    reach[column] = kind.kind == Joint::Kind::prismatic
                        ? 1
                        : std::max(from_axis(world.a), from_axis(world.b)) + world.radius;
  }
  return reach;
}

double largest_lever(const Posture& posture) {
  const Eigen::Matrix3Xd jacobian = posture.jacobian();
  const double largest = jacobian.cols() > 0 ? jacobian.colwise().norm().maxCoeff() : 0;
  return largest > 0 ? largest : 1;
}

NearestOfCapsules nearest_points(const model::Capsule& p, const model::Capsule& q) {
  // Ericson, Real-Time Collision Detection, 5.1.9.
  const Vector3d u = p.b - p.a, v = q.b - q.a, r = p.a - q.a;
  const double a = u.squaredNorm(), e = v.squaredNorm(), f = v.dot(r), c = u.dot(r), b = u.dot(v);
  const auto clamped = [](double x) { return std::clamp(x, 0.0, 1.0); };
  double s = 0, t = 0;
  if (a > 0 && e > 0) {
    const double determinant = a * e - b * b;
    s = determinant > 1e-12 * a * e ? clamped((b * f - c * e) / determinant) : 0;
    t = (b * s + f) / e;
    if (t < 0)
      t = 0, s = clamped(-c / a);
    else if (t > 1)
      t = 1, s = clamped((b - c) / a);
  } else if (a > 0) {
    s = clamped(-c / a);
  } else if (e > 0) {
    t = clamped(f / e);
  }
  NearestOfCapsules nearest{p.a + s * u, q.a + t * v, Vector3d::UnitZ(), 0};
  const Vector3d between = nearest.on_first - nearest.on_second;
  const double length = between.norm();
  if (length > 0)
    nearest.away = between / length;
  else if (const Vector3d normal = u.cross(v); normal.norm() > 0)
    nearest.away = normal.normalized();
  nearest.distance = length - p.radius - q.radius;
  return nearest;
}

double distance_between(const model::Capsule& p, const model::Capsule& q) {
  return nearest_points(p, q).distance;
}

std::vector<PairOfParts> pairs_to_keep_apart(const Robot& robot, const std::vector<BodyPart>& parts) {
  const Posture rest(robot, resting(robot));
  std::vector<PairOfParts> pairs;
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = i + 1; j < parts.size(); ++j)
      if (!are_joined(robot, parts[i].link, parts[j].link) &&
          distance_between(in_world(parts[i], rest), in_world(parts[j], rest)) > 0)
        pairs.push_back({i, j});
  return pairs;
}

}  // namespace limpet::kinematics
