// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/arm_placement.hpp>

#include <cmath>
#include <limpet/evaluation/true_surface.hpp>
#include <limpet/kinematics/body.hpp>
#include <limpet/simulation/random_start.hpp>
#include <limpet/survey/random.hpp>
#include <numbers>
#include <vector>

namespace limpet::app {
namespace {

using Eigen::Vector3d;
using kinematics::Configuration;
using kinematics::Posture;
using kinematics::Robot;
using survey::Random;

constexpr int kPlaces = 40, kConfigurations = 200;  ///< tried: bases with starts, and configurations for each

/// How far the control point can be from the base: the sum of what joins the joints on the way to it.
double reach_of(const Robot& robot) {
  double reach = robot.control_point.position.norm();
  for (std::optional<std::size_t> i = robot.control_point.link; i && robot.links[*i].parent;
       i = robot.links[*i].parent)
    reach += robot.links[*i].mounting.translation().norm();
  return reach;
}

Robot standing_at(const Robot& robot, const Vector3d& base, double bearing_rad) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = base;
  pose.linear() = Eigen::AngleAxisd(bearing_rad, Vector3d::UnitZ()).toRotationMatrix();
  return kinematics::placed(robot, pose);
}

Configuration random_configuration(const Robot& robot, Random& random) {
  Configuration at(static_cast<Eigen::Index>(robot.joint_count()));
  Eigen::Index k = 0;
  for (const kinematics::Link& link : robot.links)
    if (link.joint.kind != kinematics::Joint::Kind::fixed)
      at[k++] = random.uniform(std::max(link.joint.low, -std::numbers::pi),
                               std::min(link.joint.high, std::numbers::pi));
  return at;
}

/// A configuration near this one with its control point there, if the damped inverse of the Jacobian leads to
/// one within the limits of the joints.
std::optional<Configuration> reaching(const Robot& robot, Configuration at, const Vector3d& to,
                                      double precision) {
  constexpr int kSteps = 100;
  for (int i = 0; i < kSteps; ++i) {
    const Posture posture(robot, at);
    const Vector3d off = to - posture.control_point();
    if (off.norm() < precision) return at;
    const Eigen::Matrix3Xd jacobian = posture.jacobian();
    const double damping = 1e-3 * jacobian.squaredNorm();
    const Eigen::Matrix3d square = jacobian * jacobian.transpose() + damping * Eigen::Matrix3d::Identity();
    Configuration step = jacobian.transpose() * square.ldlt().solve(off);
    constexpr double kLongest = 0.3;
    if (step.norm() > kLongest) step *= kLongest / step.norm();
    Robot free = robot;
    free.ceilings = {};
    at += kinematics::limited(Posture(free, at), step);
  }
  return std::nullopt;
}

/// Is all of the arm clear of the surface and of itself?
bool is_clear(const Robot& robot, const Configuration& at, const evaluation::TrueSurface& surface,
              const PlacementOptions& options) {
  const Posture posture(robot, at);
  const auto body = kinematics::moving_body(robot, options.spared);
  std::vector<model::Capsule> parts;
  for (const kinematics::BodyPart& part : body) parts.push_back(kinematics::in_world(part, posture));
  for (const model::Capsule& part : parts)
    if (surface.distance_along(part.a, part.b) - part.radius < options.link_distance) return false;
  for (const auto& [i, j] : kinematics::pairs_to_keep_apart(robot, body))
    if (kinematics::distance_between(parts[i], parts[j]) < options.own_distance) return false;
  return true;
}

}  // namespace

ArmPlacement place_beside(const Robot& robot, const simulation::Mesh& object,
                          const PlacementOptions& options) {
  const simulation::Bounds bounds = simulation::bounds_of(object);
  const evaluation::TrueSurface surface(object);
  const double reach = reach_of(robot), half = (bounds.high - bounds.low).head<2>().norm() / 2;
  Random random(options.seed ^ 0x61726d706c616365u);
  for (int place = 0; place < kPlaces; ++place) {
    const double bearing = random.uniform(-std::numbers::pi, std::numbers::pi);
    const double distance = half + reach * random.uniform(0.15, 0.35);
    Vector3d base = bounds.centre() + distance * Vector3d(std::cos(bearing), std::sin(bearing), 0);
    base.z() = bounds.low.z();
    const Robot standing = standing_at(robot, base, random.uniform(-std::numbers::pi, std::numbers::pi));
    const Vector3d start = options.start
                               ? *options.start
                               : simulation::random_start(object, options.follow_distance,
                                                          options.seed + static_cast<std::uint64_t>(place));
    for (int i = 0; i < kConfigurations; ++i) {
      const auto at =
          reaching(standing, random_configuration(standing, random), start, 1e-3 * options.follow_distance);
      if (at && is_clear(standing, *at, surface, options)) return {standing, *at};
    }
  }
  throw simulation::MeshError(
      "no configuration is found in which the arm feels the object and is clear of it");
}

}  // namespace limpet::app
