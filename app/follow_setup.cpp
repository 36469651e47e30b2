// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/follow_setup.hpp>

#include <algorithm>
#include <cmath>
#include <limpet/app/arguments.hpp>
#include <limpet/app/robot_file.hpp>
#include <limpet/io/text.hpp>
#include <limpet/kinematics/arm.hpp>
#include <stdexcept>

namespace limpet::app {

constexpr double kDegree = 0.017453292519943295;

SceneFile scene_of(const FollowArguments& args) {
  SceneFile scene = read_scene(args.scene);
  if (!args.robot.empty()) scene.robot.kind = args.robot;
  scene.robot.package_paths = args.package_paths;
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

/// Throws UsageError when an error is said of a sensor that the robot does not have.
void require_sensors(const kinematics::Robot& robot, const simulation::SensingErrors& errors) {
  for (const auto& stuck : errors.stuck)
    if (stuck.sensor >= robot.sensors.size())
      throw UsageError("stuck in [errors]: the robot has no sensor " + std::to_string(stuck.sensor) +
                       "; its sensors are 0 to " + std::to_string(robot.sensors.size() - 1));
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

/// A robot other than the point robot. The thesis's arm is as large against λ as there (§4.3: λ is 0.05).
kinematics::Robot arm_of(const SceneRobot& robot, const following::Parameters& p) {
  if (*robot.kind == "arm") return kinematics::arm(kinematics::scaled({}, p.resolution / 0.05));
  return read_robot(*robot.kind, robot.package_paths).robot;
}

/// Throws UsageError when a robot is not the three sliders that following knows so far.
void require_followed(const kinematics::Robot& robot) {
  using Kind = kinematics::Joint::Kind;
  const auto turns = [](const kinematics::Link& link) { return link.joint.kind == Kind::revolute; };
  if (robot.joint_count() != 3 || std::any_of(robot.links.begin(), robot.links.end(), turns))
    throw UsageError("--robot: following with this robot is not built yet; there is point");
}

kinematics::Robot robot_of(const SceneFile& scene, const following::Parameters& p, std::uint64_t seed) {
  if (scene.robot.kind.value_or("point") != "point") return arm_of(scene.robot, p);
  const double ceiling = scene.robot.ceiling.value_or(p.resolution);
  if (!(ceiling > 0 && ceiling < p.sensing_range))
    throw UsageError("the ceiling γ of " + io::short_text(ceiling) +
                     " must be positive and below the sensing range of " + io::short_text(p.sensing_range));
  return kinematics::point_robot(
      {p.sensing_range, ceiling, simulation::rotation_of(scene.robot.heading, seed)});
}

/// What the model is to expect of the readings: their own noise and that of where they are taken from.
model::Parameters model_of(const SceneFile& scene, const simulation::BuiltWorld& world, double resolution) {
  model::Parameters p;
  p.resolution = resolution;
  p.angle_rad = scene.parameters.angle_rad.value_or(p.angle_rad);
  if (!scene.parameters.noise && world.image.empty() == false && !world.truth)
    throw UsageError("how exact the points of a range image are is not known: give --noise");
  const survey::NoiseLaw noise = scene.parameters.noise.value_or(survey::NoiseLaw{scene.errors.noise, 0, 0});
  p.noise = std::hypot(noise.fixed, scene.errors.encoder_noise);
  p.noise_per_range = noise.per_range;
  p.noise_per_range2 = noise.per_range2;
  p.tolerance = scene.parameters.tolerance.value_or(std::max(3 * p.noise, resolution / 5));
  if (scene.parameters.redundancy) {
    p.redundancy_count = scene.parameters.redundancy->count;
    p.redundancy_ratio = scene.parameters.redundancy->ratio;
  }
  return p;
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
  setup.robot = robot_of(scene, setup.following, setup.seed);
  require_followed(setup.robot);
  setup.model = model_of(scene, setup.world, resolution);
  require_sensors(setup.robot, scene.errors);
  setup.errors = scene.errors;
  setup.strategy = scene.strategy.value_or(following::Strategy::frontier);
  setup.max_sets = scene.max_sets.value_or(1'000'000);
  setup.start = scene.start
                    ? *scene.start
                    : simulation::random_start(setup.world, setup.following.follow_distance, setup.seed);
  return setup;
}

FollowSetup make_setup(const FollowArguments& args) { return make_setup(scene_of(args)); }

}  // namespace limpet::app
