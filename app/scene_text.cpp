// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/scene_text.hpp>

#include <cmath>
#include <filesystem>
#include <limits>
#include <limpet/io/text.hpp>
#include <limpet/simulation/shapes.hpp>
#include <nlohmann/json.hpp>
#include <numbers>
#include <vector>

namespace limpet::app {
namespace {

namespace fs = std::filesystem;

/// A text in quotes, as JSON and TOML have it.
std::string quoted_text(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// The degrees that scene files give for this angle: those that become just this.
double degrees_of(double angle_rad) {
  constexpr double kRadiansADegree = std::numbers::pi / 180;
  constexpr int kTries = 8;
  const double infinity = std::numeric_limits<double>::infinity();
  double below = angle_rad / kRadiansADegree, above = below;
  for (int i = 0; i < kTries; ++i) {
    if (below * kRadiansADegree == angle_rad) return below;
    if (above * kRadiansADegree == angle_rad) return above;
    below = std::nextafter(below, -infinity), above = std::nextafter(above, infinity);
  }
  return angle_rad / kRadiansADegree;
}

/// Lines of one section; its heading is there when it has any.
class SectionText {
 public:
  SectionText(std::string name, std::string folder) : name_(std::move(name)), folder_(std::move(folder)) {}

  void put(const std::string& key, const std::string& value) { lines_ += key + " = " + value + "\n"; }
  void text(const std::string& key, const std::string& value) { put(key, quoted_text(value)); }
  void number(const std::string& key, double value) { put(key, shown(value)); }
  void numbers(const std::string& key, const std::vector<double>& values) {
    std::string list;
    for (const double value : values) list += (list.empty() ? "" : ", ") + shown(value);
    put(key, "[" + list + "]");
  }
  void vector(const std::string& key, const Eigen::Vector3d& v) { numbers(key, {v.x(), v.y(), v.z()}); }
  void angle(const std::string& key, double angle_rad) { number(key, degrees_of(angle_rad)); }
  void flag(const std::string& key, bool value) {
    if (value) put(key, "true");
  }
  void file(const std::string& key, const std::string& path) {
    if (!path.empty()) text(key, from_folder(path));
  }
  void turn(const std::string& key, const simulation::Turn& turn) {
    if (turn.random) text(key, "random");
    if (turn.quaternion)
      numbers(key,
              {(*turn.quaternion)[0], (*turn.quaternion)[1], (*turn.quaternion)[2], (*turn.quaternion)[3]});
    if (turn.euler_deg) vector(key + "_deg", *turn.euler_deg);
  }
  std::string from_folder(const std::string& path) const {
    const fs::path base = folder_.empty() ? fs::current_path() : fs::absolute(folder_);
    return fs::absolute(path).lexically_proximate(base.lexically_normal()).generic_string();
  }
  static std::string shown(double value) {
    std::string number;
    io::append(number, value);
    return number;
  }
  std::string done() const {
    return name_.empty() || lines_.empty() ? lines_ : "\n[" + name_ + "]\n" + lines_;
  }

 private:
  std::string name_, folder_, lines_;
};

void put_run(const SceneFile& scene, SectionText& run) {
  if (scene.seed) run.put("seed", std::to_string(*scene.seed));
  if (scene.max_sets) run.put("max_sets", std::to_string(*scene.max_sets));
  if (scene.strategy)
    run.text("strategy", *scene.strategy == following::Strategy::thesis ? "thesis" : "frontier");
  if (scene.start) run.vector("start", *scene.start);
}

void put_world(const simulation::WorldDescription& from, SectionText& world) {
  if (simulation::is_shape(from.mesh))
    world.text("shape", from.mesh);
  else
    world.file("mesh", from.mesh);
  world.file("image", from.image);
  if (from.placement.scale != 1) world.number("scale", from.placement.scale);
  world.turn("rotation", from.placement.turn);
  if (from.placement.position != Eigen::Vector3d::Zero()) world.vector("position", from.placement.position);
  if (from.direction) world.vector("direction", *from.direction);
  if (from.pitch) world.number("pitch", *from.pitch);
  if (from.epsilon) world.number("epsilon", *from.epsilon);
  world.flag("two_sided", from.two_sided);
}

void put_initial(const simulation::WorldDescription& from, SectionText& initial) {
  initial.file("mesh", from.initial_mesh);
  std::vector<double> faces(from.initial_faces.begin(), from.initial_faces.end());
  if (!faces.empty()) initial.numbers("faces", faces);
  initial.flag("occluded", from.initial_occluded);
}

void put_robot(const SceneRobot& from, SectionText& robot) {
  if (from.kind == "point" || from.kind == "arm")
    robot.text("kind", *from.kind);
  else if (from.kind)
    robot.file("file", *from.kind);
  if (!from.package_paths.empty()) {
    std::string list;
    for (const std::string& path : from.package_paths)
      list += (list.empty() ? "" : ", ") + quoted_text(robot.from_folder(path));
    robot.put("package_path", "[" + list + "]");
  }
  if (from.object_place)
    robot.text("object", *from.object_place == ObjectPlace::on_ground ? "on_ground" : "in_reach");
  if (from.avoidance)
    robot.text("avoidance", *from.avoidance == following::Redundancy::thesis ? "thesis" : "programme");
  if (from.link_sensors)
    robot.text("link_sensors", *from.link_sensors == LinkSensors::switches ? "switches" : "range");
  if (from.gain) robot.number("gain", *from.gain);
  if (from.exponent) robot.put("exponent", std::to_string(*from.exponent));
  if (from.influence) robot.number("influence", *from.influence);
  if (from.sensing_range) robot.number("sensing_range", *from.sensing_range);
  if (from.ceiling) robot.number("ceiling", *from.ceiling);
  if (from.ceiling_rad) robot.angle("ceiling_deg", *from.ceiling_rad);
  robot.turn("heading", from.heading);
}

void put_parameters(const SceneParameters& from, SectionText& parameters) {
  if (from.resolution) parameters.number("resolution", *from.resolution);
  if (from.angle_rad) parameters.angle("angle", *from.angle_rad);
  if (from.noise)
    parameters.numbers("noise", {from.noise->fixed, from.noise->per_range, from.noise->per_range2});
  if (from.tolerance) parameters.number("tolerance", *from.tolerance);
  if (from.redundancy) parameters.numbers("redundancy", {from.redundancy->count, from.redundancy->ratio});
  if (from.follow_distance) parameters.number("follow_distance", *from.follow_distance);
  if (from.step) parameters.number("step", *from.step);
  if (from.stray) parameters.number("stray", *from.stray);
  if (from.period) parameters.put("period", std::to_string(*from.period));
}

void put_errors(const simulation::SensingErrors& from, SectionText& errors) {
  const auto put = [&errors](const std::string& key, double value) {
    if (value != 0) errors.number(key, value);
  };
  put("noise", from.noise);
  put("noise_at_angle", from.noise_at_angle);
  put("dropouts", from.dropouts);
  put("outliers", from.outliers);
  std::string stuck;
  for (const auto& [sensor, distance] : from.stuck)
    stuck += (stuck.empty() ? "{ sensor = " : ", { sensor = ") + std::to_string(sensor) +
             ", distance = " + SectionText::shown(distance) + " }";
  if (!stuck.empty()) errors.put("stuck", "[" + stuck + "]");
  std::string joints;
  for (const auto& [joint, set] : from.stuck_joints)
    joints += (joints.empty() ? "{ joint = " : ", { joint = ") + std::to_string(joint) +
              ", set = " + std::to_string(set) + " }";
  if (!joints.empty()) errors.put("stuck_joints", "[" + joints + "]");
  put("encoder_noise", from.encoder_noise);
  put("encoder_noise_deg", degrees_of(from.encoder_noise_rad));
}

}  // namespace

std::string scene_text(const SceneFile& scene, const std::string& folder) {
  SectionText run("", folder), world("world", folder), initial("initial", folder), robot("robot", folder),
      parameters("parameters", folder), errors("errors", folder);
  put_run(scene, run);
  put_world(scene.world, world);
  put_initial(scene.world, initial);
  put_robot(scene.robot, robot);
  put_parameters(scene.parameters, parameters);
  put_errors(scene.errors, errors);
  return run.done() + world.done() + initial.done() + robot.done() + parameters.done() + errors.done();
}

}  // namespace limpet::app
