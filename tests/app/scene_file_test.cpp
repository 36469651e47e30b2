// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limpet/app/scene_file.hpp>
#include <limpet/io/error.hpp>
#include <limpet/survey/random.hpp>

#include "../temporary_folder.hpp"

namespace limpet::app {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

class SceneFileTest : public limpet::testing::TemporaryFolder {
 protected:
  SceneFile parse(const std::string& text) const { return parse_scene(text, path("scene.toml")); }

  /// What is said of a scene, without the folder; empty: it is fine.
  std::string complaint(const std::string& text) const {
    try {
      parse(text);
    } catch (const io::InputError& error) {
      const std::string what = error.what(), folder = path("");
      EXPECT_TRUE(what.starts_with(folder)) << what;
      EXPECT_EQ(what.find('\n'), std::string::npos) << what;
      return what.substr(folder.size());
    }
    return {};
  }
  /// A world, and more on the lines after it, from line 3 on.
  std::string with_world(const std::string& more) const {
    return complaint("[world]\nshape = \"cube\"\n" + more);
  }
};

TEST_F(SceneFileTest, TakesAllThatIsSaid) {
  write("image.xyz", "0 0 0\n1 0 0\n");
  write("faces.off", "OFF\n0 0 0\n");
  const SceneFile scene = parse(R"(
seed = 7
max_sets = 500
strategy = "thesis"
start = [1, 2.5, -3]
[world]
image = "image.xyz"
scale = 2
rotation_deg = [10, 20, 30]
position = [4, 5, 6]
direction = [0, 0, -1]
epsilon = 0.0118
two_sided = true
[initial]
mesh = "faces.off"
[robot]
kind = "point"
object = "on_ground"
link_sensors = "switches"
sensing_range = 0.3
ceiling = 0.06
ceiling_deg = 90
heading = [1, 0, 0, 1]
[parameters]
resolution = 0.04
angle = 45
noise = [0.001, 0.002]
tolerance = 0.02
redundancy = [10, 0.1]
follow_distance = 0.09
step = 0.08
stray = 0.25
period = 12
[errors]
noise = 0.001
noise_at_angle = 0.5
dropouts = 0.1
outliers = 0.2
stuck = [{ sensor = 3, distance = 0.1 }, { sensor = 4, distance = 0 }]
encoder_noise = 0.003
encoder_noise_deg = 180
)");
  EXPECT_EQ(scene.seed, 7u);
  EXPECT_EQ(scene.max_sets, 500);
  EXPECT_EQ(scene.strategy, following::Strategy::thesis);
  EXPECT_EQ(scene.start, Vector3d(1, 2.5, -3));
  EXPECT_EQ(scene.world.image, path("image.xyz"));
  EXPECT_EQ(scene.world.mesh, "");
  EXPECT_EQ(scene.world.placement.scale, 2);
  EXPECT_EQ(scene.world.placement.turn.euler_deg, Vector3d(10, 20, 30));
  EXPECT_EQ(scene.world.placement.position, Vector3d(4, 5, 6));
  EXPECT_EQ(scene.world.direction, Vector3d(0, 0, -1));
  EXPECT_EQ(scene.world.epsilon, 0.0118);
  EXPECT_TRUE(scene.world.two_sided);
  EXPECT_EQ(scene.world.initial_mesh, path("faces.off"));
  EXPECT_EQ(scene.robot.kind, "point");
  EXPECT_EQ(scene.robot.object_place, ObjectPlace::on_ground);
  EXPECT_EQ(scene.robot.link_sensors, LinkSensors::switches);
  EXPECT_EQ(scene.robot.sensing_range, 0.3);
  EXPECT_EQ(scene.robot.ceiling, 0.06);
  EXPECT_DOUBLE_EQ(*scene.robot.ceiling_rad, std::acos(0.0));
  EXPECT_EQ(scene.robot.heading.quaternion, Vector4d(1, 0, 0, 1));
  EXPECT_EQ(scene.parameters.resolution, 0.04);
  EXPECT_DOUBLE_EQ(*scene.parameters.angle_rad, std::atan(1.0));
  EXPECT_EQ(scene.parameters.noise->fixed, 0.001);
  EXPECT_EQ(scene.parameters.noise->per_range, 0.002);
  EXPECT_EQ(scene.parameters.noise->per_range2, 0);
  EXPECT_EQ(scene.parameters.tolerance, 0.02);
  EXPECT_EQ(scene.parameters.redundancy->count, 10);
  EXPECT_EQ(scene.parameters.redundancy->ratio, 0.1);
  EXPECT_EQ(scene.parameters.follow_distance, 0.09);
  EXPECT_EQ(scene.parameters.step, 0.08);
  EXPECT_EQ(scene.parameters.stray, 0.25);
  EXPECT_EQ(scene.parameters.period, 12);
  EXPECT_EQ(scene.errors.noise, 0.001);
  EXPECT_EQ(scene.errors.noise_at_angle, 0.5);
  EXPECT_EQ(scene.errors.dropouts, 0.1);
  EXPECT_EQ(scene.errors.outliers, 0.2);
  ASSERT_EQ(scene.errors.stuck.size(), 2u);
  EXPECT_EQ(scene.errors.stuck[0].sensor, 3u);
  EXPECT_EQ(scene.errors.stuck[0].distance, 0.1);
  EXPECT_EQ(scene.errors.encoder_noise, 0.003);
  EXPECT_DOUBLE_EQ(scene.errors.encoder_noise_rad, std::acos(-1.0));
  EXPECT_EQ(scene.errors.seed, 7u);
}

TEST_F(SceneFileTest, LeavesOpenWhatIsNotSaid) {
  const SceneFile scene = parse("[world]\nshape = \"cube\"\n[robot]\n[parameters]\n[errors]\n");
  EXPECT_EQ(scene.world.mesh, "cube");
  EXPECT_EQ(scene.world.placement.scale, 1);
  EXPECT_FALSE(scene.seed || scene.max_sets || scene.strategy || scene.start || scene.robot.kind);
  EXPECT_FALSE(scene.robot.sensing_range || scene.robot.ceiling || scene.robot.ceiling_rad);
  EXPECT_FALSE(scene.parameters.resolution || scene.parameters.noise || scene.parameters.period);
  EXPECT_FALSE(scene.robot.heading.random || scene.robot.heading.quaternion || scene.robot.heading.euler_deg);
  EXPECT_NO_THROW(require_sound(scene.errors));
  EXPECT_EQ(scene.errors.noise, 0);
}

TEST_F(SceneFileTest, ImagesOfMeshesAndFacesByNumber) {
  const SceneFile scene = parse(
      "[world]\nshape = \"L\"\nrotation = \"random\"\ndirection = [1, 2, 3]\npitch = 0.01\n[initial]\nfaces "
      "= [0, 3]\n"
      "[parameters]\nnoise = 0.002\n[robot]\nheading = \"random\"\n");
  EXPECT_EQ(scene.world.pitch, 0.01);
  EXPECT_TRUE(scene.world.placement.turn.random);
  EXPECT_TRUE(scene.robot.heading.random);
  EXPECT_EQ(scene.world.initial_faces, (std::vector<int>{0, 3}));
  EXPECT_EQ(scene.parameters.noise->fixed, 0.002);
}

TEST_F(SceneFileTest, UnknownKeysAreErrorsThatSayWhatIsKnown) {
  EXPECT_EQ(with_world("[initial]\noccluded = false\nresolution = 1\n"),
            "scene.toml:5: unknown key 'resolution' in [initial]; known are: mesh, faces, occluded");
  EXPECT_EQ(with_world("\n[parameters]\nresolutoin = 0.1\nangel = 3\n"),
            "scene.toml:5: unknown key 'resolutoin' in [parameters]; known are: resolution, angle, noise, "
            "tolerance, "
            "redundancy, follow_distance, step, stray, period");
  EXPECT_EQ(
      with_world("[wrold]\n"),
      "scene.toml:3: unknown key 'wrold'; known are: seed, max_sets, strategy, start, world, initial, robot, "
      "parameters, errors");
  EXPECT_EQ(with_world("[errors]\nstuck = [{ sensor = 1, distanse = 2 }]\n"),
            "scene.toml:4: unknown key 'distanse' in [errors.stuck]; known are: sensor, distance");
}

TEST_F(SceneFileTest, ValuesOfTheWrongKindAreErrors) {
  const auto in = [this](const std::string& section, const std::string& line) {
    return with_world("[" + section + "]\n" + line + "\n");
  };
  EXPECT_EQ(in("parameters", "resolution = \"fine\""),
            "scene.toml:4: 'resolution' in [parameters] must be a number more than 0");
  EXPECT_EQ(in("parameters", "step = 0"),
            "scene.toml:4: 'step' in [parameters] must be a number more than 0");
  EXPECT_EQ(in("parameters", "step = inf"),
            "scene.toml:4: 'step' in [parameters] must be a number more than 0");
  EXPECT_EQ(in("parameters", "angle = 90"),
            "scene.toml:4: 'angle' in [parameters] must be less than 90 degrees");
  EXPECT_EQ(in("parameters", "period = 2.5"),
            "scene.toml:4: 'period' in [parameters] must be a whole number of 2 or more, up to 1000000");
  EXPECT_EQ(in("parameters", "period = 1"),
            "scene.toml:4: 'period' in [parameters] must be a whole number of 2 or more, up to 1000000");
  EXPECT_EQ(in("parameters", "noise = [1, 2, 3, 4]"),
            "scene.toml:4: 'noise' in [parameters] must be a list of 1 to 3 numbers of 0 or more");
  EXPECT_EQ(in("parameters", "noise = -1"),
            "scene.toml:4: 'noise' in [parameters] must be a number of 0 or more");
  EXPECT_EQ(in("parameters", "redundancy = [20]"),
            "scene.toml:4: 'redundancy' in [parameters] must be a list of 2 numbers of 0 or more");
  EXPECT_EQ(in("errors", "dropouts = 1.5"),
            "scene.toml:4: 'dropouts' in [errors] must be a number from 0 to 1");
  EXPECT_EQ(in("errors", "stuck = 3"),
            "scene.toml:4: 'stuck' in [errors] must be a list of tables, as in stuck = [{ sensor = … }]");
  EXPECT_EQ(in("errors", "stuck = [{ sensor = 3 }]"),
            "scene.toml:4: [errors.stuck] needs one of these keys: distance");
  EXPECT_EQ(
      in("robot", "kind = \"leg\""),
      "scene.toml:4: 'kind' in [robot] must be \"point\" or \"arm\"; of a robot from a file give 'file'");
  EXPECT_EQ(in("robot", "link_sensors = \"skin\""),
            "scene.toml:4: 'link_sensors' in [robot] must be \"range\" or \"switches\"");
  EXPECT_EQ(in("robot", "avoidance = \"none\""),
            "scene.toml:4: 'avoidance' in [robot] must be \"programme\" or \"thesis\"");
  EXPECT_EQ(in("robot", "object = \"far\""),
            "scene.toml:4: 'object' in [robot] must be \"in_reach\" or \"on_ground\"");
  EXPECT_EQ(in("robot", "heading = \"north\""),
            "scene.toml:4: 'heading' in [robot] must be \"random\" or [w, x, y, z]");
  EXPECT_EQ(in("robot", "heading = [0, 0, 0, 0]"),
            "scene.toml:4: 'heading' in [robot] must not be zero: give [1, 0, 0, 0]");
  EXPECT_EQ(in("robot", "heading = [1, 2, 3]"),
            "scene.toml:4: 'heading' in [robot] must be a list of 4 numbers");
  EXPECT_EQ(in("robot", "heading = \"random\"\nheading_deg = [1, 2, 3]"),
            "scene.toml:5: 'heading_deg' in [robot] and 'heading' exclude each other: leave one out");
  EXPECT_EQ(in("initial", "faces = [-1]"),
            "scene.toml:4: 'faces' in [initial] must be a list of whole numbers of 0 or more");
  EXPECT_EQ(complaint("seed = -1\n[world]\nshape = \"cube\"\n"),
            "scene.toml:1: 'seed' must be a whole number of 0 or more");
  EXPECT_EQ(complaint("start = [1, 2]\n[world]\nshape = \"cube\"\n"),
            "scene.toml:1: 'start' must be a list of 3 numbers");
  EXPECT_EQ(complaint("strategy = \"best\"\n[world]\nshape = \"cube\"\n"),
            "scene.toml:1: 'strategy' must be \"frontier\" or \"thesis\"");
  EXPECT_EQ(complaint("world = 3\n"),
            "scene.toml:1: 'world' must be a table: begin it with [world] on a line of its own");
}

TEST_F(SceneFileTest, AWorldIsNeededAndOneOnly) {
  write("a.off", "OFF");
  EXPECT_EQ(complaint(""),
            "scene.toml:1: a scene needs a world: add [world] with shape = \"cube\", a mesh or an image");
  EXPECT_EQ(complaint("seed = 1\n[world]\nscale = 2\n"),
            "scene.toml:2: [world] needs one of these keys: shape, mesh, image");
  EXPECT_EQ(complaint("[world]\nshape = \"cube\"\nmesh = \"a.off\"\n"),
            "scene.toml:3: 'mesh' in [world] and 'shape' exclude each other: leave one out");
  EXPECT_TRUE(
      complaint("[world]\nshape = \"cub\"\n")
          .starts_with("scene.toml:2: 'shape' in [world] is the name of no shape; known are: cube, L, "));
  EXPECT_EQ(complaint("[world]\nshape = \"city:0\"\n"),
            "scene.toml:2: 'shape' in [world]: not a possible shape parameter: 0");
  EXPECT_EQ(complaint("[world]\nmesh = \"b.off\"\n"),
            "scene.toml:2: 'mesh' in [world] names a file that is not there: " + path("b.off") +
                "; names are relative to the scene file");
}

TEST_F(SceneFileTest, WhatDoesNotGoTogetherIsAnError) {
  write("image.xyz", "0 0 0\n1 0 0\n");
  EXPECT_EQ(
      with_world("epsilon = 0.1\n"),
      "scene.toml:3: 'epsilon' in [world] is of range images: give 'image', or 'pitch' and 'direction', too");
  EXPECT_EQ(with_world("pitch = 0.1\n"),
            "scene.toml:3: 'pitch' in [world] needs 'direction' too: where the scanner looked");
  EXPECT_EQ(with_world("pitch = 0.1\ndirection = [0, 0, 0]\n"),
            "scene.toml:4: 'direction' in [world] must not be zero");
  EXPECT_EQ(complaint("[world]\nimage = \"image.xyz\"\npitch = 0.1\n"),
            "scene.toml:3: 'pitch' in [world] is for an image taken of a mesh or a shape: leave it out");
  EXPECT_EQ(complaint("[world]\nimage = \"image.xyz\"\n[initial]\nfaces = [1]\n"),
            "scene.toml:4: 'faces' in [initial] are those of a mesh or a shape; of an image give 'mesh'");
  EXPECT_EQ(with_world("[initial]\noccluded = true\n"),
            "scene.toml:4: 'occluded' in [initial] is for an image of a mesh: give 'pitch' and 'direction' "
            "in [world]");
}

TEST_F(SceneFileTest, WhatIsNoTomlIsAnErrorWithItsLine) {
  for (const std::string text :
       {"[world]\nshape = cube\n", "[world\n", "[world]\nshape = \"cube\"\nshape = \"L\"\n",
        "[world]\nshape = \"a\nb\"\n", "\xff\xfe", "x = [1, 2\n\n"}) {
    const std::string what = complaint(text);
    EXPECT_TRUE(what.starts_with("scene.toml:")) << what;
    EXPECT_TRUE(what.size() > 11 && what[11] >= '1' && what[11] <= '9') << what;
  }
}

TEST_F(SceneFileTest, CharactersBeyondAsciiAreForStringsAndComments) {
  for (const std::string text : {"\xC3\xA9 = 1", "[\xC3\xA9]", "x = 1 \xC3\xA9", "\xC2\xA0x = 1",
                                 "x = '''\n''' \xE2\x82\xAC", "x = \"\\\"\" \xE2\x82\xAC"})
    EXPECT_NE(complaint("# a line\n" + text + "\n").find("beyond ASCII"), std::string::npos) << text;
  EXPECT_TRUE(complaint("# a line\nx = 1 \xC3\xA9\n").starts_with("scene.toml:2: "));
  for (const std::string text : {"# \xC3\xA9 'no string\n", "# \"\n", "\xEF\xBB\xBF"})
    EXPECT_EQ(complaint(text + "[world]\nshape = \"cube\"\n"), "") << text;
  EXPECT_EQ(complaint("[world]\nshape = \"\xC3\xA9\"\n").find("beyond ASCII"), std::string::npos);
}

TEST_F(SceneFileTest, DamagedFilesAreScenesOrErrorsInOneLine) {
  const std::string whole = read(LIMPET_SOURCE_DIR "/scenes/noisy_L.toml");
  survey::Random random(1);
  int refused = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    std::string text = whole;
    for (std::uint64_t k = random.below(4) + 1; k > 0; --k) {
      const std::size_t at = random.below(text.size());
      switch (random.below(4)) {
        case 0:
          text[at] = static_cast<char>(random.below(256));
          break;
        case 1:
          text.erase(at, random.below(20));
          break;
        case 2:
          text.insert(at, text.substr(random.below(text.size()), random.below(30)));
          break;
        default:
          text.insert(at, 1, "[]{}=\"'.,-\n#0"[random.below(14)]);
      }
    }
    refused += !complaint(text).empty();
  }
  EXPECT_GT(refused, 1000);
}

TEST_F(SceneFileTest, ASceneIsAlsoAShapeOrAMesh) {
  EXPECT_EQ(read_scene("cube").world.mesh, "cube");
  EXPECT_EQ(read_scene("part.off").world.mesh, "part.off");
  EXPECT_THROW(read_scene("part.xyz"), UsageError);
  EXPECT_THROW(read_scene(path("missing.toml")), io::InputError);
  std::filesystem::create_directory(path("folder.toml"));
  EXPECT_THROW(read_scene(path("folder.toml")), io::InputError);
  EXPECT_EQ(read_scene(write("scene.toml", "[world]\nshape = \"L\"\n")).world.mesh, "L");
}

TEST_F(SceneFileTest, TheExamplesAreScenes) {
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(LIMPET_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    ++scenes;
    const SceneFile scene = read_scene(entry.path().string());
    const simulation::BuiltWorld built = simulation::build_world(scene.world, scene.seed.value_or(1));
    EXPECT_TRUE(built.world) << entry.path();
    const Vector3d start = simulation::random_start(built, *scene.parameters.resolution * 2, 1);
    EXPECT_TRUE(start.allFinite()) << entry.path();
    EXPECT_EQ(built.initial.empty(), !scene.world.initial_occluded) << entry.path();
  }
  EXPECT_GE(scenes, 3);
}

}  // namespace
}  // namespace limpet::app
