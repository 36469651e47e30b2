// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/scene_file.hpp>

#include <fstream>
#include <iterator>
#include <limits>
#include <limpet/app/toml_section_internal.hpp>
#include <limpet/io/error.hpp>
#include <limpet/io/text.hpp>
#include <limpet/simulation/scene.hpp>
#include <limpet/simulation/shapes.hpp>
#include <numbers>
#include <utility>

namespace limpet::app {
namespace {

using simulation::Turn;
using simulation::WorldDescription;

constexpr std::int64_t kAnyWhole = std::numeric_limits<std::int64_t>::max();
constexpr double kDegree = std::numbers::pi / 180;

std::optional<double> in_radians(const std::optional<double>& degrees) {
  if (!degrees) return std::nullopt;
  return *degrees * kDegree;
}

/// A rotation is in `key` ("random", or w, x, y, z of a quaternion) or in `key_deg` (roll, pitch, yaw).
Turn read_turn(const TomlSection& section, const std::string& key) {
  section.require_one({key, key + "_deg"}, false);
  Turn turn;
  turn.euler_deg = section.vector(key + "_deg");
  if (!section.has(key)) return turn;
  if (section.is_text(key)) {
    if (section.text(key) != "random")
      section.fail(key, section.called(key) + " must be \"random\" or [w, x, y, z]");
    turn.random = true;
    return turn;
  }
  const auto q = *section.numbers(key, 4, 4, Numbers::any);
  turn.quaternion = Eigen::Vector4d(q[0], q[1], q[2], q[3]);
  if (turn.quaternion->norm() == 0)
    section.fail(key, section.called(key) + " must not be zero: give [1, 0, 0, 0]");
  return turn;
}

std::string read_shape(const TomlSection& world) {
  const std::string name = world.text("shape").value_or("");
  if (!simulation::is_shape(name)) {
    std::string known;
    for (const std::string& shape : simulation::shape_names()) known += (known.empty() ? "" : ", ") + shape;
    world.fail("shape", world.called("shape") + " is the name of no shape; known are: " + known);
  }
  try {
    simulation::feature_size(name);  // looks at the parameters, too
  } catch (const simulation::MeshError& error) {
    world.fail("shape", world.called("shape") + ": " + error.what());
  }
  return name;
}

void require_image(const TomlSection& world, const std::string& key, bool is_image) {
  if (world.has(key) && !is_image)
    world.fail(key, world.called(key) + " is of range images: give 'image', or 'pitch' and 'direction', too");
}

void read_world(const TomlSection& file, WorldDescription& out) {
  const auto world = file.section("world", {"shape", "mesh", "image", "position", "rotation", "rotation_deg",
                                            "scale", "direction", "pitch", "epsilon", "two_sided"});
  if (!world)
    file.fail("world", "a scene needs a world: add [world] with shape = \"cube\", a mesh or an image");
  world->require_one({"shape", "mesh", "image"}, true);
  out.mesh = world->has("shape") ? read_shape(*world) : world->file("mesh").value_or("");
  out.image = world->file("image").value_or("");
  out.placement.scale = world->number("scale", Numbers::positive).value_or(1);
  out.placement.turn = read_turn(*world, "rotation");
  out.placement.position = world->vector("position").value_or(Eigen::Vector3d::Zero());
  out.direction = world->vector("direction");
  out.pitch = world->number("pitch", Numbers::positive);
  out.epsilon = world->number("epsilon", Numbers::positive);
  out.two_sided = world->flag("two_sided");
  if (out.direction && out.direction->norm() == 0)
    world->fail("direction", world->called("direction") + " must not be zero");
  if (out.pitch && !out.image.empty())
    world->fail("pitch",
                world->called("pitch") + " is for an image taken of a mesh or a shape: leave it out");
  if (out.pitch && !out.direction)
    world->fail("pitch", world->called("pitch") + " needs 'direction' too: where the scanner looked");
  for (const char* key : {"direction", "epsilon", "two_sided"})
    require_image(*world, key, out.pitch || !out.image.empty());
}

void read_initial(const TomlSection& file, WorldDescription& out) {
  const auto initial = file.section("initial", {"mesh", "faces", "occluded"});
  if (!initial) return;
  initial->require_one({"mesh", "faces", "occluded"}, true);
  out.initial_mesh = initial->file("mesh").value_or("");
  out.initial_faces = initial->indices("faces").value_or(std::vector<int>{});
  out.initial_occluded = initial->flag("occluded");
  if (initial->has("faces") && out.mesh.empty())
    initial->fail("faces",
                  initial->called("faces") + " are those of a mesh or a shape; of an image give 'mesh'");
  if (out.initial_occluded && !out.pitch)
    initial->fail("occluded", initial->called("occluded") +
                                  " is for an image of a mesh: give 'pitch' and 'direction' in [world]");
}

void read_robot(const TomlSection& file, SceneRobot& out) {
  const auto robot = file.section(
      "robot", {"kind", "file", "package_path", "avoidance", "gain", "exponent", "influence", "link_sensors",
                "object", "sensing_range", "ceiling", "ceiling_deg", "heading", "heading_deg"});
  if (!robot) return;
  robot->require_one({"kind", "file"}, false);
  out.kind = robot->text("kind");
  if (out.kind && *out.kind != "point" && *out.kind != "arm")
    robot->fail("kind",
                robot->called("kind") + " must be \"point\" or \"arm\"; of a robot from a file give 'file'");
  if (const auto path = robot->file("file")) out.kind = path;
  for (const std::string& name : robot->texts("package_path").value_or(std::vector<std::string>{}))
    out.package_paths.push_back(robot->beside(name));
  constexpr std::int64_t kMostExponent = 1000;
  out.gain = robot->number("gain", Numbers::not_negative);
  out.influence = robot->number("influence", Numbers::positive);
  if (const auto exponent = robot->whole("exponent", 1, kMostExponent))
    out.exponent = static_cast<int>(*exponent);
  if (const auto avoidance = robot->text("avoidance")) {
    if (*avoidance != "programme" && *avoidance != "thesis")
      robot->fail("avoidance", robot->called("avoidance") + " must be \"programme\" or \"thesis\"");
    out.avoidance = *avoidance == "thesis" ? following::Redundancy::thesis : following::Redundancy::programme;
  }
  if (const auto object = robot->text("object")) {
    if (*object != "on_ground" && *object != "in_reach")
      robot->fail("object", robot->called("object") + " must be \"in_reach\" or \"on_ground\"");
    out.object_place = *object == "on_ground" ? ObjectPlace::on_ground : ObjectPlace::in_reach;
  }
  if (const auto sensors = robot->text("link_sensors")) {
    if (*sensors != "range" && *sensors != "switches")
      robot->fail("link_sensors", robot->called("link_sensors") + " must be \"range\" or \"switches\"");
    out.link_sensors = parse_link_sensors("link_sensors", *sensors);
  }
  out.sensing_range = robot->number("sensing_range", Numbers::positive);
  out.ceiling = robot->number("ceiling", Numbers::positive);
  out.ceiling_rad = in_radians(robot->number("ceiling_deg", Numbers::positive));
  out.heading = read_turn(*robot, "heading");
}

survey::NoiseLaw read_noise_law(const TomlSection& parameters) {
  if (!parameters.is_list("noise")) return {*parameters.number("noise", Numbers::not_negative), 0, 0};
  auto numbers = *parameters.numbers("noise", 1, 3, Numbers::not_negative);
  numbers.resize(3);
  return {numbers[0], numbers[1], numbers[2]};
}

void read_parameters(const TomlSection& file, SceneParameters& out) {
  const auto parameters =
      file.section("parameters", {"resolution", "angle", "noise", "tolerance", "redundancy",
                                  "follow_distance", "step", "stray", "period"});
  if (!parameters) return;
  out.resolution = parameters->number("resolution", Numbers::positive);
  const auto angle = parameters->number("angle", Numbers::positive);
  if (angle && *angle >= 90)
    parameters->fail("angle", parameters->called("angle") + " must be less than 90 degrees");
  out.angle_rad = in_radians(angle);
  if (parameters->has("noise")) out.noise = read_noise_law(*parameters);
  out.tolerance = parameters->number("tolerance", Numbers::positive);
  if (const auto values = parameters->numbers("redundancy", 2, 2, Numbers::not_negative))
    out.redundancy = RedundancyArgument{(*values)[0], (*values)[1]};
  out.follow_distance = parameters->number("follow_distance", Numbers::positive);
  out.step = parameters->number("step", Numbers::positive);
  out.stray = parameters->number("stray", Numbers::positive);
  if (const auto period = parameters->whole("period", 2, 1'000'000)) out.period = static_cast<int>(*period);
}

void read_errors(const TomlSection& file, simulation::SensingErrors& out) {
  const auto errors = file.section("errors", {"noise", "noise_at_angle", "dropouts", "outliers", "stuck",
                                              "stuck_joints", "encoder_noise", "encoder_noise_deg"});
  if (!errors) return;
  out.noise = errors->number("noise", Numbers::not_negative).value_or(0);
  out.noise_at_angle = errors->number("noise_at_angle", Numbers::not_negative).value_or(0);
  out.dropouts = errors->number("dropouts", Numbers::fraction).value_or(0);
  out.outliers = errors->number("outliers", Numbers::fraction).value_or(0);
  errors->each("stuck", {"sensor", "distance"}, [&out](const TomlSection& stuck) {
    stuck.require_one({"sensor"}, true);
    stuck.require_one({"distance"}, true);
    out.stuck.push_back({static_cast<std::size_t>(*stuck.whole("sensor", 0, kAnyWhole)),
                         *stuck.number("distance", Numbers::not_negative)});
  });
  errors->each("stuck_joints", {"joint", "set"}, [&out](const TomlSection& stuck) {
    stuck.require_one({"joint"}, true);
    out.stuck_joints.push_back({static_cast<std::size_t>(*stuck.whole("joint", 0, kAnyWhole)),
                                stuck.whole("set", 0, kAnyWhole).value_or(0)});
  });
  out.encoder_noise = errors->number("encoder_noise", Numbers::not_negative).value_or(0);
  out.encoder_noise_rad = in_radians(errors->number("encoder_noise_deg", Numbers::not_negative)).value_or(0);
}

void read_run(const TomlSection& file, SceneFile& out) {
  out.start = file.vector("start");
  if (const auto strategy = file.text("strategy")) {
    if (*strategy == "frontier")
      out.strategy = following::Strategy::frontier;
    else if (*strategy == "thesis")
      out.strategy = following::Strategy::thesis;
    else
      file.fail("strategy", file.called("strategy") + " must be \"frontier\" or \"thesis\"");
  }
  if (const auto seed = file.whole("seed", 0, kAnyWhole)) out.seed = static_cast<std::uint64_t>(*seed);
  out.max_sets = file.whole("max_sets", 1, kAnyWhole);
  if (out.seed) out.errors.seed = *out.seed;
}

std::string read_text(const std::string& path) {
  refuse_folder(path);
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw io::InputError(path, "cannot be opened");
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace

SceneFile parse_scene(const std::string& text, const std::string& path) {
  const TomlSection file = TomlSection::parse(text, path);
  file.allow({"seed", "max_sets", "strategy", "start", "world", "initial", "robot", "parameters", "errors"});
  SceneFile scene;
  read_world(file, scene.world);
  read_initial(file, scene.world);
  read_robot(file, scene.robot);
  read_parameters(file, scene.parameters);
  read_errors(file, scene.errors);
  read_run(file, scene);
  return scene;
}

SceneFile read_scene(const std::string& scene) {
  if (io::extension_of(scene) == "toml") return parse_scene(read_text(scene), scene);
  if (!simulation::is_scene_name(scene))
    throw UsageError("'" + scene + "' is no scene: give the name of a shape, a mesh file or a .toml file");
  SceneFile file;
  file.world.mesh = scene;
  return file;
}

}  // namespace limpet::app
