// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/arm_placement.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <limpet/kinematics/body.hpp>
#include <limpet/simulation/random_start.hpp>
#include <limpet/survey/random.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "placed_object_internal.hpp"

namespace limpet::app {
namespace {

using Eigen::Vector3d;
using internal::PlacedObject;
using kinematics::Configuration;
using kinematics::Joint;
using kinematics::Posture;
using kinematics::Robot;
using survey::Random;

constexpr int kPlaces = 100, kConfigurations = 60;  ///< tried: bases with starts, and configurations for each

/// Of an object that suits an arm: its largest side over the arm's reach. The thesis's is 1, its arm's
/// reach 3.
constexpr double kSideOverReach = 1.0 / 3;

/// The joint that carries all others that move. Precondition: there is one.
std::size_t first_moved(const Robot& robot) {
  std::size_t i = 0;
  while (robot.links[i].joint.kind == Joint::Kind::fixed) ++i;
  return i;
}

Robot standing_at(const Robot& robot, const Vector3d& base, double heading_rad) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = base;
  pose.linear() = Eigen::AngleAxisd(heading_rad, Vector3d::UnitZ()).toRotationMatrix();
  return kinematics::placed(robot, pose);
}

/// At a random place for its base.
Robot standing_beside(const Robot& robot, double reach, const simulation::Bounds& object,
                      const std::optional<double>& side, ObjectPlace object_place, Random& random) {
  const double around = side ? std::numbers::pi / 3 : std::numbers::pi;
  const double bearing = side.value_or(0) + random.uniform(-around, around);
  const Vector3d outward(std::cos(bearing), std::sin(bearing), 0);
  const double half = (object.high - object.low).head<2>().norm() / 2;
  Vector3d base;
  if (object_place == ObjectPlace::on_ground) {
    base = object.centre() + (half + reach * random.uniform(0.15, 0.35)) * outward;
    base.z() = object.low.z();
  } else {
    const double distance = reach * random.uniform(0.4, 0.5), height = reach * random.uniform(0.3, 0.4);
    base = object.centre() + std::max(distance, half + 0.1 * reach) * outward;
    base.z() -= height;
  }
  const double towards = bearing + std::numbers::pi;
  return standing_at(robot, base, towards + random.uniform(-std::numbers::pi / 3, std::numbers::pi / 3));
}

/// The bearing, from the object's middle, of the side of it that a range image shows; none: all of it can be
/// felt, or the image is of no one side.
std::optional<double> side_shown(const simulation::BuiltWorld& world, const simulation::Bounds& object) {
  constexpr double kLeast = 0.05;  // of the object
  if (world.image.empty()) return std::nullopt;
  Vector3d middle = Vector3d::Zero();
  for (const Vector3d& point : world.image) middle += point / static_cast<double>(world.image.size());
  const Eigen::Vector2d side = (middle - object.centre()).head<2>();
  if (side.norm() < kLeast * (object.high - object.low).norm()) return std::nullopt;
  return std::atan2(side.y(), side.x());
}

Configuration random_configuration(const Robot& robot, Random& random) {
  Configuration at(static_cast<Eigen::Index>(robot.joint_count()));
  kinematics::for_each_moving_joint(robot, [&](Eigen::Index k, const Joint& joint) {
    at[k] = random.uniform(std::max(joint.low, -std::numbers::pi), std::min(joint.high, std::numbers::pi));
  });
  return at;
}

/// A configuration near this one with its control point there, if the damped inverse of the Jacobian leads to
/// one within the limits of the joints.
std::optional<Configuration> reaching(const Robot& robot, Configuration at, const Vector3d& to,
                                      double precision) {
  constexpr int kSteps = 100;
  constexpr double kLongest = 0.3;
  for (int i = 0; i < kSteps; ++i) {
    const Posture posture(robot, at);
    const Vector3d off = to - posture.control_point();
    if (off.norm() < precision) return at;
    const Eigen::Matrix3Xd jacobian = posture.jacobian();
    const double damping = 1e-3 * jacobian.squaredNorm();
    const Eigen::Matrix3d square = jacobian * jacobian.transpose() + damping * Eigen::Matrix3d::Identity();
    Configuration step = jacobian.transpose() * square.ldlt().solve(off);
    if (step.norm() > kLongest) step *= kLongest / step.norm();
    at = kinematics::within_limits(robot, at + step);
  }
  return std::nullopt;
}

/// Two parts of the body, and how far apart they are to be.
struct PairApart {
  std::size_t first = 0, second = 0;
  double distance = 0;
};

/// Pairs that are never so far apart, as where axes cross in a wrist, are to be half of what they can be.
std::vector<PairApart> pairs_of(const Robot& robot, const std::vector<kinematics::BodyPart>& body,
                                double distance) {
  constexpr int kTries = 200;
  std::vector<PairApart> pairs;
  for (const auto& [i, j] : kinematics::pairs_to_keep_apart(robot, body)) pairs.push_back({i, j, 0});
  Random random(0x7061697273u);
  for (int i = 0; i < kTries; ++i) {
    const Posture posture(robot, random_configuration(robot, random));
    for (PairApart& pair : pairs)
      pair.distance = std::max(
          pair.distance, kinematics::distance_between(kinematics::in_world(body[pair.first], posture),
                                                      kinematics::in_world(body[pair.second], posture)));
  }
  for (PairApart& pair : pairs) pair.distance = std::min(distance, pair.distance / 2);
  return pairs;
}

/// The part of the body that the control point is so near to that it cannot be off a surface δ away from the
/// control point, in any of many postures.
std::optional<std::size_t> part_in_the_way(const Robot& robot, const PlacementOptions& options) {
  constexpr int kTries = 50;
  const auto body = kinematics::moving_body(robot, options.spared);
  std::vector<double> farthest(body.size(), -std::numeric_limits<double>::infinity());
  Random random(0x70617274u);
  for (int i = 0; i < kTries; ++i) {
    const Posture posture(robot, random_configuration(robot, random));
    const model::Capsule point{posture.control_point(), posture.control_point(), 0};
    for (std::size_t k = 0; k < body.size(); ++k)
      farthest[k] =
          std::max(farthest[k], kinematics::distance_between(kinematics::in_world(body[k], posture), point));
  }
  for (std::size_t k = 0; k < body.size(); ++k)
    if (options.follow_distance + farthest[k] < options.link_distance) return body[k].link;
  return std::nullopt;
}

/// What makes a posture one to begin with.
class Beginning {
 public:
  Beginning(const Robot& robot, const simulation::BuiltWorld& world, const PlacementOptions& options)
      : world_(*world.world),
        object_(world, 1e-3 * options.link_distance),
        options_(options),
        body_(kinematics::moving_body(robot, options.spared)),
        pairs_(pairs_of(robot, body_, options.own_distance)) {}

  const simulation::Bounds& bounds() const { return object_.bounds(); }

  bool is_good(const Posture& posture) const { return is_clear(posture) && feels(posture); }

  /// Does the part of the robot that no joint moves keep off the object?
  bool stands_clear(const Robot& standing) const {
    const Posture posture(standing, Configuration::Zero(static_cast<Eigen::Index>(standing.joint_count())));
    for (std::size_t i = 0; i < standing.links.size(); ++i) {
      if (kinematics::is_moved(standing, i)) continue;
      for (const model::Capsule& capsule : standing.links[i].body)
        if (object_.distance(kinematics::in_world({i, capsule}, posture)) < options_.link_distance)
          return false;
    }
    return true;
  }

 private:
  bool is_clear(const Posture& posture) const {
    std::vector<model::Capsule> parts;
    for (const kinematics::BodyPart& part : body_) parts.push_back(kinematics::in_world(part, posture));
    for (const PairApart& pair : pairs_)
      if (kinematics::distance_between(parts[pair.first], parts[pair.second]) < pair.distance) return false;
    return std::all_of(parts.begin(), parts.end(), [this](const model::Capsule& part) {
      return object_.distance(part) >= options_.link_distance;
    });
  }

  /// Does a sensor of the control point's link meet the surface?
  bool feels(const Posture& posture) const {
    const Robot& robot = posture.robot();
    for (std::size_t i = 0; i < robot.sensors.size(); ++i) {
      if (robot.sensors[i].link != robot.control_point.link) continue;
      const Posture::Sensor sensor = posture.sensor(i);
      if (world_.sight(sensor.position, sensor.axis, sensor.range)) return true;
    }
    return false;
  }

  const simulation::World& world_;
  const PlacedObject object_;
  const PlacementOptions& options_;
  const std::vector<kinematics::BodyPart> body_;
  const std::vector<PairApart> pairs_;
};

/// Of this many configurations, the first one that is good to begin with.
std::optional<Configuration> beginning(const Robot& standing, const Vector3d& start, const Beginning& wanted,
                                       const PlacementOptions& options, Random& random) {
  for (int i = 0; i < kConfigurations; ++i) {
    const Configuration from =
        i == 0 && options.posture ? *options.posture : random_configuration(standing, random);
    const auto at = reaching(standing, from, start, 1e-3 * options.follow_distance);
    if (at && wanted.is_good(Posture(standing, *at))) return at;
  }
  return std::nullopt;
}

std::string two_digits(double number) {
  char rounded[32];
  std::snprintf(rounded, sizeof rounded, "%.2g", number);
  return rounded;
}

std::string what_would_help(const Robot& robot, double suits, const PlacementOptions& options) {
  if (const auto link = part_in_the_way(robot, options))
    return "its control point is within or close to link '" + robot.links[*link].name +
           "': put it farther out by [control_point] in a robot file (.toml)";
  if (suits < 0.9 || suits > 3)
    return "scale it by about " + two_digits(suits) +
           " ('scale' in [world] of a scene file), and choose --resolution by the sensing range, a quarter "
           "of it";
  return "give another --seed or --start";
}

[[noreturn]] void fail_to_place(const Robot& robot, double reach, const simulation::Bounds& bounds,
                                const PlacementOptions& options) {
  const Vector3d size = bounds.high - bounds.low;
  throw simulation::MeshError(
      "the robot finds no place where it feels the object and is clear of it: it reaches " +
      two_digits(reach) + ", and the object measures " + two_digits(size.x()) + " x " + two_digits(size.y()) +
      " x " + two_digits(size.z()) + ": " +
      what_would_help(robot, kSideOverReach * reach / size.maxCoeff(), options));
}

}  // namespace

double reach_of(const Robot& robot) {
  constexpr int kTries = 1000;
  const std::size_t first = first_moved(robot);
  Random random(0x7265616368u);
  double reach = 0;
  for (int i = 0; i < kTries; ++i) {
    const Posture posture(robot, random_configuration(robot, random));
    reach = std::max(reach, (posture.control_point() - posture.link(first).translation()).norm());
  }
  return reach;
}

ArmPlacement place_beside(const Robot& robot, const simulation::BuiltWorld& world,
                          const PlacementOptions& options) {
  const Beginning wanted(robot, world, options);
  const double reach = reach_of(robot);
  const std::optional<double> side = side_shown(world, wanted.bounds());
  Random random(options.seed ^ 0x61726d706c616365u);
  for (int place = 0; place < kPlaces; ++place) {
    Robot standing = standing_beside(robot, reach, wanted.bounds(), side, options.object_place, random);
    if (!wanted.stands_clear(standing)) continue;
    const Vector3d start = options.start
                               ? *options.start
                               : simulation::random_start(world, options.follow_distance,
                                                          options.seed + static_cast<std::uint64_t>(place));
    if (const auto at = beginning(standing, start, wanted, options, random))
      return {std::move(standing), *at};
  }
  fail_to_place(robot, reach, wanted.bounds(), options);
}

}  // namespace limpet::app
