// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/follow_setup.hpp>

#include <algorithm>
#include <cmath>
#include <limpet/app/arguments.hpp>
#include <limpet/app/arm_placement.hpp>
#include <limpet/app/robot_file.hpp>
#include <limpet/io/text.hpp>
#include <limpet/kinematics/arm.hpp>
#include <stdexcept>
#include <utility>

namespace limpet::app {

constexpr double kDegree = 0.017453292519943295;

SceneFile scene_of(const FollowArguments& args) {
  SceneFile scene = read_scene(args.scene);
  if (!args.robot.empty()) scene.robot.kind = args.robot;
  scene.robot.package_paths.insert(scene.robot.package_paths.begin(), args.package_paths.begin(),
                                   args.package_paths.end());
  if (args.avoidance) scene.robot.avoidance = args.avoidance;
  if (args.link_sensors) scene.robot.link_sensors = args.link_sensors;
  if (args.resolution) scene.parameters.resolution = args.resolution;
  if (args.angle_deg) scene.parameters.angle_rad = *args.angle_deg * kDegree;
  if (args.redundancy) scene.parameters.redundancy = args.redundancy;
  if (args.noise) {
    scene.parameters.noise = survey::NoiseLaw{*args.noise, 0, 0};
    scene.errors.noise = *args.noise;
  }
  if (args.encoder_noise) scene.errors.encoder_noise = *args.encoder_noise;
  if (args.start) scene.start = args.start;
  if (args.strategy) scene.strategy = args.strategy;
  if (args.seed) scene.errors.seed = (scene.seed = args.seed).value();
  if (args.max_sets) scene.max_sets = args.max_sets;
  if (!args.initial.empty()) {
    scene.world.initial_mesh = args.initial;
    scene.world.initial_faces.clear();
    scene.world.initial_occluded = false;
  }
  return scene;
}

namespace {

/// Throws UsageError when an error is said of a sensor or joint that the robot does not have.
void require_parts(const kinematics::Robot& robot, const simulation::SensingErrors& errors) {
  for (const auto& stuck : errors.stuck)
    if (stuck.sensor >= robot.sensors.size())
      throw UsageError("stuck in [errors]: the robot has no sensor " + std::to_string(stuck.sensor) +
                       "; its sensors are 0 to " + std::to_string(robot.sensors.size() - 1));
  for (const auto& stuck : errors.stuck_joints)
    if (stuck.joint >= robot.joint_count())
      throw UsageError("stuck_joints in [errors]: the robot has no joint " + std::to_string(stuck.joint) +
                       "; its joints are 0 to " + std::to_string(robot.joint_count() - 1));
}

double resolution_of(const SceneFile& scene, const simulation::BuiltWorld& world) {
  if (scene.parameters.resolution) return *scene.parameters.resolution;
  if (world.truth) return chosen_resolution(*world.truth);
  throw UsageError("the resolution that a range image asks for is not known: give --resolution");
}

following::Parameters following_of(const SceneFile& scene, double resolution) {
  following::Parameters p = following::usual_parameters(resolution);
  p.sensing_range = scene.robot.sensing_range.value_or(p.sensing_range);
  p.follow_distance = scene.parameters.follow_distance.value_or(p.follow_distance);
  p.max_step = scene.parameters.step.value_or(p.max_step);
  p.stray_limit = scene.parameters.stray.value_or(p.sensing_range);
  p.progress_period = scene.parameters.period.value_or(p.progress_period);
  p.angle_rad = scene.parameters.angle_rad.value_or(p.angle_rad);
  try {
    require_sound(p);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  return p;
}

/// A robot other than the point robot, from a file or built in, and where it begins if that is said. The
/// thesis's arm is as large against λ as there (§4.3: λ is 0.05).
RobotFile arm_of(const SceneRobot& robot, double resolution) {
  if (*robot.kind != "arm") return read_robot(*robot.kind, robot.package_paths);
  constexpr double kThesis = 0.05;
  const kinematics::ArmOptions options = kinematics::scaled({}, resolution / kThesis);
  return {kinematics::arm(options), options.sensing_range, std::nullopt, ""};
}

kinematics::Robot with_switches_on_links(const kinematics::Robot& robot) {
  kinematics::Robot switched = kinematics::with_switches(robot);
  if (switched.sensors.empty())
    throw UsageError(
        "link sensors: the robot has no range sensor at its control point: with switches on its links it "
        "would have none");
  return switched;
}

kinematics::Robot point_robot_of(const SceneFile& scene, const following::Parameters& p, std::uint64_t seed) {
  const double ceiling = scene.robot.ceiling.value_or(p.resolution);
  if (!(ceiling > 0 && ceiling < p.sensing_range))
    throw UsageError("the ceiling γ of " + io::short_text(ceiling) +
                     " must be positive and below the sensing range of " + io::short_text(p.sensing_range));
  return kinematics::point_robot(
      {p.sensing_range, ceiling, simulation::rotation_of(scene.robot.heading, seed)});
}

/// What noise of the measured positions of revolute joints makes of readings at the control point, by what
/// the joints move it in the posture of the start; of each coordinate.
double noise_by_turns(const simulation::SensingErrors& errors, const kinematics::Posture& start) {
  double squares = 0;
  const Eigen::Matrix3Xd jacobian = start.jacobian();
  kinematics::for_each_moving_joint(start.robot(), [&](Eigen::Index k, const kinematics::Joint& joint) {
    if (joint.kind == kinematics::Joint::Kind::revolute) squares += jacobian.col(k).squaredNorm();
  });
  return errors.encoder_noise_rad * std::sqrt(squares / 3);
}

/// What the model is to expect of the readings: their own noise and that of where they are taken from, of
/// which `turned_noise` comes from revolute joints.
model::Parameters model_of(const SceneFile& scene, const simulation::BuiltWorld& world, double resolution,
                           double turned_noise) {
  model::Parameters p;
  p.resolution = resolution;
  p.angle_rad = scene.parameters.angle_rad.value_or(p.angle_rad);
  if (!scene.parameters.noise && world.image.empty() == false && !world.truth)
    throw UsageError("how exact the points of a range image are is not known: give --noise");
  const survey::NoiseLaw noise = scene.parameters.noise.value_or(survey::NoiseLaw{scene.errors.noise, 0, 0});
  p.noise = std::hypot(noise.fixed, std::hypot(scene.errors.encoder_noise, turned_noise));
  p.noise_per_range = noise.per_range;
  p.noise_per_range2 = noise.per_range2;
  p.tolerance = scene.parameters.tolerance.value_or(std::max(3 * p.noise, resolution / 5));
  if (scene.parameters.redundancy) {
    p.redundancy_count = scene.parameters.redundancy->count;
    p.redundancy_ratio = scene.parameters.redundancy->ratio;
  }
  return p;
}

void place_point_robot(const SceneFile& scene, FollowSetup& setup) {
  if (scene.robot.link_sensors)
    throw UsageError(
        "link sensors are for robots with links, and the point robot has none: give --robot arm");
  setup.robot = point_robot_of(scene, setup.following, setup.seed);
  setup.start = scene.start
                    ? *scene.start
                    : simulation::random_start(setup.world, setup.following.follow_distance, setup.seed);
  setup.configuration = setup.start;
}

/// An arm with another sensing range than what goes with λ is followed with by its own.
void place_arm(const SceneFile& scene, FollowSetup& setup) {
  RobotFile arm = arm_of(scene.robot, setup.following.resolution);
  if (scene.robot.link_sensors == LinkSensors::switches) arm.robot = with_switches_on_links(arm.robot);
  if (arm.sensing_range <= setup.following.follow_distance)
    throw UsageError("the robot's sensors reach " + io::short_text(arm.sensing_range) +
                     ", no farther than the follow distance of " +
                     io::short_text(setup.following.follow_distance) + ": give a smaller --resolution");
  setup.following.sensing_range = setup.following.stray_limit = arm.sensing_range;
  setup.links = following::usual_link_parameters(
      setup.following, scene.robot.avoidance.value_or(following::Redundancy::programme));
  kinematics::RedundancyParameters& objective = setup.links->objective;
  objective.gain = scene.robot.gain.value_or(objective.gain);
  objective.exponent = scene.robot.exponent.value_or(objective.exponent);
  objective.influence = scene.robot.influence.value_or(objective.influence);
  PlacementOptions options;
  options.object_place = scene.robot.object_place.value_or(options.object_place);
  options.follow_distance = setup.following.follow_distance;
  options.link_distance = 1.5 * setup.links->least_distance;
  options.own_distance = 2 * setup.links->own_distance;
  options.spared = setup.links->spared;
  options.start = scene.start;
  options.posture = arm.start;
  options.seed = setup.seed;
  ArmPlacement placement = place_beside(arm.robot, setup.world, options);
  setup.robot = std::move(placement.robot);
  setup.chosen_tip = arm.chosen_tip;
  if (scene.robot.ceiling_rad) setup.robot.ceilings.revolute_rad = *scene.robot.ceiling_rad;
  setup.configuration = std::move(placement.start);
  setup.start = kinematics::Posture(setup.robot, setup.configuration).control_point();
}

}  // namespace

double chosen_resolution(const simulation::Mesh& mesh) {
  const simulation::Bounds bounds = simulation::bounds_of(mesh);
  const double side = (bounds.high - bounds.low).maxCoeff();
  return std::clamp(simulation::narrowest_place(mesh) / 4, side / 40, side / 20);
}

FollowSetup make_setup(const SceneFile& scene) {
  FollowSetup setup;
  setup.seed = scene.seed.value_or(1);
  setup.world = simulation::build_world(scene.world, setup.seed);
  const double resolution = resolution_of(scene, setup.world);
  setup.following = following_of(scene, resolution);
  setup.errors = scene.errors;
  setup.strategy = scene.strategy.value_or(following::Strategy::frontier);
  setup.max_sets = scene.max_sets.value_or(1'000'000);
  if (scene.robot.kind.value_or("point") == "point")
    place_point_robot(scene, setup);
  else
    place_arm(scene, setup);
  require_parts(setup.robot, scene.errors);
  setup.model = model_of(scene, setup.world, resolution,
                         noise_by_turns(scene.errors, kinematics::Posture(setup.robot, setup.configuration)));
  return setup;
}

FollowSetup make_setup(const FollowArguments& args) { return make_setup(scene_of(args)); }

}  // namespace limpet::app
