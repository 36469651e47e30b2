// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/robot_file.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limpet/app/arguments.hpp>
#include <limpet/app/toml_section_internal.hpp>
#include <limpet/io/error.hpp>
#include <limpet/io/text.hpp>
#include <limpet/kinematics/mesh_path.hpp>
#include <limpet/kinematics/reach.hpp>
#include <limpet/kinematics/sensor_patterns.hpp>
#include <limpet/kinematics/urdf.hpp>
#include <limpet/simulation/mesh.hpp>
#include <numbers>
#include <stdexcept>

#include "robot_sensors_internal.hpp"

namespace limpet::app {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;
using kinematics::Joint;
using kinematics::Robot;
using kinematics::UrdfOptions;

constexpr double kRadian = std::numbers::pi / 180;  // of a degree
constexpr double kReachOverRange = 15;              // of the thesis's arm: 3 and 0.2

std::vector<Vector3d> load_corners(const std::string& path) {
  const simulation::Mesh mesh = simulation::load_mesh(path);
  std::vector<Vector3d> corners;
  for (const auto& triangle : mesh.triangles)
    for (const int i : triangle) corners.push_back(mesh.vertices[static_cast<std::size_t>(i)]);
  return corners;
}

std::string folder_of(const std::string& path) { return fs::path(path).parent_path().string(); }

/// The paths of the command line, then those of the file, which are relative to it.
std::vector<std::string> paths_of(const TomlSection& file, const std::string& path,
                                  const std::vector<std::string>& given) {
  std::vector<std::string> paths = given;
  for (const std::string& name : file.texts("package_path").value_or(std::vector<std::string>{}))
    paths.push_back((fs::path(folder_of(path)) / name).lexically_normal().string());
  return paths;
}

std::string find_urdf(const TomlSection& file, const std::string& path,
                      const std::vector<std::string>& paths) {
  const auto name = file.text("urdf");
  if (!name) file.fail("urdf", "a robot file needs urdf = \"FILE.urdf\": the links and joints of the robot");
  if (auto found = kinematics::find_robot_file(*name, folder_of(path), paths)) return *found;
  std::string sought = "beside this file";
  for (const std::string& folder : paths) sought += ", in " + folder;
  file.fail("urdf", file.called("urdf") + " names a file that is not there: " + *name + "; it was sought " +
                        sought + ": say where it is by --package-path DIR");
}

model::Capsule read_capsule(const TomlSection& capsule) {
  for (const char* key : {"a", "b", "radius"}) capsule.require_one({key}, true);
  return {*capsule.vector("a"), *capsule.vector("b"), *capsule.number("radius", Numbers::not_negative)};
}

void read_shapes(const TomlSection& file, UrdfOptions& options) {
  const auto shapes = file.table("shapes");
  if (!shapes) return;
  for (const std::string& link : shapes->keys()) {
    const TomlSection shape = *shapes->section(link, {"capsules"});
    shape.require_one({"capsules"}, true);
    std::vector<model::Capsule>& body = options.shapes[link];
    shape.each("capsules", {"a", "b", "radius"},
               [&body](const TomlSection& capsule) { body.push_back(read_capsule(capsule)); });
  }
}

void read_locked(const TomlSection& file, UrdfOptions& options) {
  for (const std::string name : {"locked", "locked_deg"}) {
    const auto joints = file.table(name);
    if (!joints) continue;
    for (const std::string& joint : joints->keys()) {
      if (options.locked.contains(joint)) joints->fail(joint, joints->called(joint) + " is in [locked], too");
      options.locked[joint] = *joints->number(joint, Numbers::any) * (name == "locked" ? 1 : kRadian);
    }
  }
}

void read_control_point(const TomlSection& file, Robot& robot) {
  const auto point = file.section("control_point", {"link", "position"});
  if (!point) return;
  robot.control_point.link = internal::link_of(robot, *point, "link");
  robot.control_point.position = point->vector("position").value_or(Vector3d::Zero());
}

/// The sensing range, when nobody says it.
double usual_range(const Robot& robot) { return kinematics::largest_reach(robot) / kReachOverRange; }

double read_range(const TomlSection& file, const Robot& robot) {
  const double range = file.number("sensing_range", Numbers::positive).value_or(usual_range(robot));
  if (!(range > 0 && std::isfinite(range)))
    file.fail("sensing_range", "what sensing range fits the robot is not known: give sensing_range");
  return range;
}

kinematics::Ceilings read_ceilings(const TomlSection& file, const Robot& robot, double range) {
  const auto prismatic = file.number("ceiling", Numbers::positive);
  const auto revolute_deg = file.number("ceiling_deg", Numbers::positive);
  kinematics::Ceilings ceilings;
  if (!prismatic || !revolute_deg) {
    try {
      ceilings = kinematics::ceilings_for(robot, range);
    } catch (const std::invalid_argument& error) {
      file.fail("ceiling",
                "the ceilings are not known: " + std::string(error.what()) + ", or ceiling and ceiling_deg");
    }
  }
  if (prismatic) ceilings.prismatic = *prismatic;
  if (revolute_deg) ceilings.revolute_rad = *revolute_deg * kRadian;
  return ceilings;
}

std::optional<kinematics::Configuration> read_start(const TomlSection& file, const Robot& robot) {
  const std::size_t joints = robot.joint_count();
  const auto values = file.numbers("start", joints, joints, Numbers::any);
  if (!values) return std::nullopt;
  kinematics::Configuration start(static_cast<Eigen::Index>(joints));
  Eigen::Index joint = 0;
  for (const kinematics::Link& link : robot.links) {
    if (link.joint.kind == Joint::Kind::fixed) continue;
    const double value = (*values)[static_cast<std::size_t>(joint)];
    start[joint] = link.joint.kind == Joint::Kind::revolute ? value * kRadian : value;
    if (start[joint] < link.joint.low || start[joint] > link.joint.high)
      file.fail("start", file.called("start") + ": " + io::short_text(value) +
                             " is beyond the limits of the joint of '" + link.name + "'");
    ++joint;
  }
  return start;
}

std::string read_robot_text(const std::string& path) {
  refuse_folder(path);
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw io::InputError(path, "cannot be opened");
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::string tip_of(const Robot& robot) { return robot.links[robot.control_point.link].name; }

/// Says where in the robot file it is that does not fit the URDF.
[[noreturn]] void fail_at(const TomlSection& file, const kinematics::UrdfOptionError& error) {
  for (const std::string table : {"shapes", "locked", "locked_deg"}) {
    const auto section = file.table(table);
    if (section && section->has(error.name()) && table.starts_with(error.key()))
      section->fail(error.name(), section->called(error.name()) + " does not fit " + error.what());
  }
  file.fail(error.key(), file.called(error.key()) + " does not fit " + error.what());
}

Robot read_urdf_of(const TomlSection& file, const std::string& urdf, const UrdfOptions& options) {
  try {
    return kinematics::read_urdf(urdf, options);
  } catch (const kinematics::UrdfOptionError& error) {
    fail_at(file, error);
  }
}

/// A URDF with nothing beside it.
RobotFile read_bare_urdf(const std::string& path, const std::vector<std::string>& package_paths) {
  UrdfOptions options;
  options.package_paths = package_paths;
  options.load_mesh = load_corners;
  RobotFile file;
  file.robot = kinematics::read_urdf(path, options);
  file.chosen_tip = tip_of(file.robot);
  file.sensing_range = usual_range(file.robot);
  if (!(file.sensing_range > 0 && std::isfinite(file.sensing_range)))
    throw io::InputError(path,
                         "what sensing range fits the robot is not known: write a robot file (.toml) with "
                         "sensing_range");
  file.robot.sensors = kinematics::usual_sensors(file.robot, file.sensing_range);
  file.robot.ceilings = kinematics::ceilings_for(file.robot, file.sensing_range);
  return file;
}

}  // namespace

RobotFile parse_robot(const std::string& text, const std::string& path,
                      const std::vector<std::string>& package_paths) {
  const TomlSection file = TomlSection::parse(text, path);
  file.allow({"urdf", "base", "tip", "package_path", "sensing_range", "ceiling", "ceiling_deg", "start",
              "control_point", "locked", "locked_deg", "shapes", "sensors"});
  UrdfOptions options;
  options.base = file.text("base").value_or("");
  options.tip = file.text("tip").value_or("");
  options.package_paths = paths_of(file, path, package_paths);
  options.load_mesh = load_corners;
  read_shapes(file, options);
  read_locked(file, options);
  RobotFile out;
  out.robot = read_urdf_of(file, find_urdf(file, path, options.package_paths), options);
  if (options.tip.empty()) out.chosen_tip = tip_of(out.robot);
  read_control_point(file, out.robot);
  out.sensing_range = read_range(file, out.robot);
  out.robot.sensors = file.has("sensors") ? internal::read_sensors(out.robot, file, out.sensing_range)
                                          : kinematics::usual_sensors(out.robot, out.sensing_range);
  out.robot.ceilings = read_ceilings(file, out.robot, out.sensing_range);
  out.start = read_start(file, out.robot);
  return out;
}

RobotFile read_robot(const std::string& path, const std::vector<std::string>& package_paths) {
  const std::string kind = io::extension_of(path);
  if (kind == "urdf") return read_bare_urdf(path, package_paths);
  if (kind == "toml") return parse_robot(read_robot_text(path), path, package_paths);
  throw UsageError("--robot " + path + ": give point, arm, a URDF (.urdf) or a robot file (.toml)");
}

}  // namespace limpet::app
