// Copyright the limpet authors. GPL-3.0-or-later.
//
// A run that touches the true surface ends there, and leaves a scene that comes to it again.
#include <limpet/app/collision_case.hpp>
#include <limpet/app/collision_watch.hpp>
#include <limpet/app/scene_text.hpp>
#include <limpet/kinematics/robot.hpp>
#include <limpet/simulation/scene.hpp>
#include <limpet/survey/random.hpp>
#include <nlohmann/json.hpp>
#include <numbers>

#include "program.hpp"

namespace limpet::app {
namespace {

using Eigen::Vector3d;

TEST(CollisionWatchTest, TheControlPointCollidesWhereItCrossesTheSurface) {
  const simulation::Mesh cube = simulation::make_scene("cube").mesh;
  const simulation::Bounds bounds = simulation::bounds_of(cube);
  const kinematics::Robot point = kinematics::point_robot({});
  CollisionWatch watch(point, cube, false, 0.01);
  const Vector3d middle = bounds.centre(), left = middle - Vector3d(2, 0, 0),
                 right = middle + Vector3d(2, 0, 0);
  EXPECT_FALSE(watch.look(left));
  EXPECT_FALSE(watch.look(left + Vector3d(0, 2, 0)));
  EXPECT_FALSE(watch.look(right + Vector3d(0, 2, 0)));
  EXPECT_FALSE(watch.look(right));
  const auto collision = watch.look(left);
  ASSERT_TRUE(collision);
  EXPECT_EQ(collision->set, 5);
  EXPECT_EQ(text_of(*collision), "the control point touched the surface at set 5");
}

class Collisions : public testing::ProgramTest {
 protected:
  nlohmann::json follow(std::vector<std::string> arguments, int code) const {
    arguments.insert(arguments.begin(), "follow");
    arguments.insert(arguments.end(), {"-q", "--json", path("run.json")});
    const auto result = run(arguments);
    EXPECT_EQ(result.code, code) << result.err;
    return nlohmann::json::parse(read(path("run.json")));
  }
};

/// The thesis's rule checks nothing: a link touches the cube.
TEST_F(Collisions, EndTheRunAndLeaveACaseThatComesToThemAgain) {
  const std::vector<std::string> thesis{"cube", "--robot", "arm", "--avoidance", "thesis", "--seed", "3"};
  auto arguments = thesis;
  arguments.insert(arguments.end(), {"-o", path("c.off")});
  const auto first = follow(arguments, 1);
  ASSERT_EQ(first["ended"], "collision");
  EXPECT_EQ(first["collision"]["set"], first["sets"]);
  EXPECT_EQ(first["collisions"], 1) << "the judge saw the same";
  EXPECT_TRUE(first["collision"]["part"].get<std::string>().starts_with("link 'link")) << first["collision"];
  const std::string text = read(path("c-collision.toml"));
  EXPECT_TRUE(text.starts_with("# link 'link")) << text;
  const auto again = follow({path("c-collision.toml"), "-o", path("c.off")}, 1);
  EXPECT_EQ(again["collision"], first["collision"]);
  EXPECT_EQ(again["path_length"], first["path_length"]);
  EXPECT_EQ(read(path("c-collision.toml")), text) << "an input is not overwritten";
  const auto below_the_comment = [](const std::string& scene) { return scene.substr(scene.find('\n')); };
  EXPECT_EQ(below_the_comment(read(path("c-collision-2.toml"))), below_the_comment(text));
  const auto counted = follow({path("c-collision.toml"), "--collisions", "count", "-o", path("c.off")}, 1);
  EXPECT_EQ(counted["ended"], "max-sets");
  EXPECT_GE(counted["collisions"], 1);
}

/// Of a cube that a scanner saw from one side, the other sides cannot be felt.
TEST_F(Collisions, OfAPointRobotEndTheRunToo) {
  write("through.toml", R"(
seed = 3
[world]
shape = "cube"
direction = [-0.6, 0.5, -0.62]
pitch = 0.0118
)");
  const auto first = follow({path("through.toml"), "-o", path("p.off")}, 1);
  ASSERT_EQ(first["ended"], "collision");
  EXPECT_EQ(first["collision"]["part"], "the control point");
  const auto again = follow({path("p-collision.toml"), "-o", path("again.off")}, 1);
  EXPECT_EQ(again["collision"], first["collision"]);
  EXPECT_EQ(read(path("again.off")), read(path("p.off")));
  EXPECT_EQ(run({"follow", "cube", "--collisions", "ignore", "-o", path("m.off")}).code, 2);
}

class SceneTextTest : public limpet::testing::TemporaryFolder {
 protected:
  SceneFile parse(const std::string& text) const { return parse_scene(text, path("scene.toml")); }
};

TEST_F(SceneTextTest, SaysAllThatTheSceneSays) {
  write("image.xyz", "0 0 0\n1 0 0\n");
  write("faces.off", "OFF\n0 0 0\n");
  write("robot.toml", "");
  const std::string text = R"(seed = 7
max_sets = 500
strategy = "thesis"
start = [1, 2.5, -0.1]

[world]
image = "image.xyz"
scale = 2.1
rotation_deg = [10, 20, 30]
position = [4, 5, 6]
direction = [0, 0, -1]
epsilon = 0.0118
two_sided = true

[initial]
mesh = "faces.off"

[robot]
file = "robot.toml"
package_path = ["meshes", "../more"]
object = "on_ground"
avoidance = "thesis"
link_sensors = "switches"
gain = 5000
exponent = 4
influence = 0.15
sensing_range = 0.3
ceiling = 0.04
ceiling_deg = 3.8
heading = "random"

[parameters]
resolution = 0.05
angle = 12.7
noise = [0.001, 0.002, 0]
tolerance = 0.01
redundancy = [20, 0.05]
follow_distance = 0.1
step = 0.07
stray = 0.2
period = 11

[errors]
noise = 0.002
noise_at_angle = 0.5
dropouts = 0.02
outliers = 0.001
stuck = [{ sensor = 3, distance = 0.1 }]
stuck_joints = [{ joint = 2, set = 100 }]
encoder_noise = 0.002
encoder_noise_deg = 0.1
)";
  EXPECT_EQ(scene_text(parse(text), path("")), text);
  const std::string little =
      "\n[world]\nshape = \"drum:64\"\nrotation = [1, 0, 0.1, 0]\n\n[initial]\nfaces = [0, 3]\n";
  EXPECT_EQ(scene_text(parse(little), path("")), little);
}

TEST_F(SceneTextTest, AnglesComeBackToTheLastBit) {
  survey::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    SceneFile scene = parse("[world]\nshape = \"cube\"\n");
    const double degrees = random.uniform(0, 90);
    scene.parameters.angle_rad = degrees * (std::numbers::pi / 180);
    EXPECT_EQ(parse(scene_text(scene, path(""))).parameters.angle_rad, scene.parameters.angle_rad) << degrees;
  }
}

TEST(CasePath, IsBesideTheModelAndNeverThatOfAnotherFile) {
  EXPECT_EQ(case_path("out/cube.off", {"cube"}), "out/cube-collision.toml");
  EXPECT_EQ(case_path("cube.limpet", {"./cube-collision.toml", "", "cube-collision-2.toml"}),
            "cube-collision-3.toml");
}

}  // namespace
}  // namespace limpet::app
