// Copyright the limpet authors. GPL-3.0-or-later.
//
// Robots from files: what a robot file may say, what is chosen where it is silent, and how wrong files are
// refused.
#include <algorithm>
#include <limpet/app/robot_file.hpp>
#include <limpet/app/run_reader.hpp>
#include <limpet/app/run_record.hpp>
#include <limpet/io/error.hpp>
#include <limpet/kinematics/arm.hpp>
#include <limpet/kinematics/reach.hpp>
#include <limpet/kinematics/urdf.hpp>
#include <numbers>

#include "../data_folder.hpp"
#include "program.hpp"

namespace limpet::app {
namespace {

using Eigen::Vector3d;
using kinematics::Robot;

const std::string kRobots = LIMPET_SOURCE_DIR "/robots/";

/// Exactly the same, but for largest velocities, which runs do not record.
void expect_same(const Robot& a, const Robot& b) {
  EXPECT_EQ(a.name, b.name);
  ASSERT_EQ(a.links.size(), b.links.size());
  for (std::size_t i = 0; i < a.links.size(); ++i) {
    const kinematics::Link &x = a.links[i], &y = b.links[i];
    EXPECT_EQ(x.name, y.name);
    EXPECT_EQ(x.parent, y.parent);
    EXPECT_EQ(x.mounting.matrix(), y.mounting.matrix()) << x.name;
    EXPECT_EQ(x.joint.kind, y.joint.kind);
    EXPECT_EQ(x.joint.axis, y.joint.axis);
    EXPECT_EQ(x.joint.low, y.joint.low);
    EXPECT_EQ(x.joint.high, y.joint.high);
    ASSERT_EQ(x.body.size(), y.body.size()) << x.name;
    for (std::size_t k = 0; k < x.body.size(); ++k) {
      EXPECT_EQ(x.body[k].a, y.body[k].a) << x.name;
      EXPECT_EQ(x.body[k].b, y.body[k].b) << x.name;
      EXPECT_EQ(x.body[k].radius, y.body[k].radius) << x.name;
    }
  }
  EXPECT_EQ(a.control_point.link, b.control_point.link);
  EXPECT_EQ(a.control_point.position, b.control_point.position);
  ASSERT_EQ(a.sensors.size(), b.sensors.size());
  for (std::size_t i = 0; i < a.sensors.size(); ++i) {
    EXPECT_EQ(a.sensors[i].link, b.sensors[i].link);
    EXPECT_EQ(a.sensors[i].position, b.sensors[i].position);
    EXPECT_EQ(a.sensors[i].axis, b.sensors[i].axis);
    EXPECT_EQ(a.sensors[i].range, b.sensors[i].range);
  }
  EXPECT_EQ(a.ceilings.prismatic, b.ceilings.prismatic);
  EXPECT_EQ(a.ceilings.revolute_rad, b.ceilings.revolute_rad);
}

class RobotFileTest : public testing::ProgramTest {
 protected:
  RobotFileTest() {
    write("arm.urdf", read(kRobots + "arm.urdf"));
    for (const char* folder : {"robot_urdf", "robot_panda", "robot_ur5"})
      data_paths_.push_back((limpet::testing::data_folder() / folder).string());
  }

  RobotFile parse(const std::string& text) const { return parse_robot(text, path("robot.toml"), {}); }

  /// What is said of a robot file, without the folder; empty: it is fine.
  std::string complaint(const std::string& text) const {
    try {
      parse(text);
    } catch (const io::InputError& error) {
      const std::string what = error.what(), folder = path("");
      EXPECT_TRUE(what.starts_with(folder)) << what;
      EXPECT_EQ(what.find('\n'), std::string::npos) << what;
      return what.substr(folder.size());
    } catch (const kinematics::RobotError& error) {
      return error.what();
    }
    return {};
  }
  /// Of a file for the arm, with more on the lines after it, from line 2 on.
  std::string with_arm(const std::string& more) const { return complaint("urdf = \"arm.urdf\"\n" + more); }
  std::string with_sensors(const std::string& more) const { return with_arm("[[sensors]]\n" + more); }

  bool has_data() const { return std::filesystem::exists(data_paths_.front()); }
  RobotFile read_with_data(const std::string& name) const { return read_robot(kRobots + name, data_paths_); }

  std::vector<std::string> data_paths_;
};

TEST_F(RobotFileTest, TheArmOfTheFileIsTheArm) {
  const RobotFile file = read_robot(kRobots + "arm.toml", {});
  expect_same(file.robot, kinematics::arm());
  EXPECT_EQ(file.sensing_range, 0.2);
  ASSERT_TRUE(file.start);
  EXPECT_DOUBLE_EQ((*file.start)[1], std::numbers::pi / 4);
}

TEST_F(RobotFileTest, AUrdfAloneIsARobot) {
  const RobotFile file = read_robot(kRobots + "arm.urdf", {});
  EXPECT_EQ(file.robot.links[file.robot.control_point.link].name, "link4");
  EXPECT_EQ(file.robot.control_point.position, Vector3d::Zero());
  EXPECT_NEAR(file.sensing_range, kinematics::largest_reach(file.robot) / 15, 1e-12);
  EXPECT_NEAR(file.robot.ceilings.revolute_rad, 1.0 / 15, 1e-12);
  EXPECT_GT(file.robot.sensors.size(), 26u);
  EXPECT_FALSE(file.start);
  for (const auto& sensor : file.robot.sensors)
    EXPECT_NE(file.robot.links[sensor.link].name, "link1");  // stands still
}

TEST_F(RobotFileTest, RealRobotsOfTheRepository) {
  if (!has_data()) GTEST_SKIP() << "no " << data_paths_.front();
  struct Real {
    std::string file;
    std::size_t joints;
  };
  for (const auto& [name, joints] : {Real{"panda.toml", 7}, {"ur5.toml", 6}, {"iiwa14.toml", 7}}) {
    const RobotFile file = read_with_data(name);
    EXPECT_EQ(file.robot.joint_count(), joints) << name;
    EXPECT_GT(file.robot.sensors.size(), 60u) << name;
    EXPECT_LT(file.robot.sensors.size(), 1000u) << name;
    ASSERT_TRUE(file.start) << name;
    const kinematics::Posture posture(file.robot, *file.start);
    EXPECT_GT(posture.control_point().norm(), 0.3) << name;
    EXPECT_NEAR(file.robot.ceilings.revolute_rad, 0.12 / kinematics::largest_reach(file.robot), 1e-12)
        << name;
    EXPECT_TRUE(
        std::any_of(file.robot.links.begin(), file.robot.links.end(),
                    [](const kinematics::Link& link) { return std::isfinite(link.joint.max_velocity); }))
        << name;
  }
}

TEST_F(RobotFileTest, RobotsComeBackFromRunFiles) {
  std::vector<Robot> robots = {kinematics::arm(), read_robot(kRobots + "arm.urdf", {}).robot};
  if (has_data())
    for (const char* name : {"panda.toml", "ur5.toml", "iiwa14.toml"})
      robots.push_back(read_with_data(name).robot);
  for (const Robot& robot : robots) {
    RunHead head;
    head.arithmetic = "exact";
    head.robot = robot;
    RunRecord record(path("r.run"), head);
    RunSet set;
    set.sensed.measured =
        kinematics::Configuration::Constant(static_cast<Eigen::Index>(robot.joint_count()), -0.3);
    const kinematics::Posture posture(robot, set.sensed.measured);
    for (std::size_t sensor = 0; sensor < robot.sensors.size(); sensor += 5) {
      set.sensed.sensors.push_back(sensor);
      set.sensed.points.push_back(posture.sensor_point(sensor, 0.05));
    }
    record.add(set);
    record.end({"stopped", {}});
    RunReader reader(path("r.run"));
    expect_same(reader.head().robot, robot);
    RunSet again;
    ASSERT_TRUE(reader.next(again));
    ASSERT_EQ(again.sensed.points.size(), set.sensed.points.size());
    for (std::size_t i = 0; i < again.sensed.points.size(); ++i)
      EXPECT_EQ(again.sensed.points[i].position, set.sensed.points[i].position);
  }
}

TEST_F(RobotFileTest, TakesAllThatIsSaid) {
  const RobotFile file = parse(R"(
urdf = "arm.urdf"
base = "link2"
tip = "link4"
sensing_range = 0.3
ceiling_deg = 2
start = [10, 20, 30, 40]
[control_point]
link = "link3"
position = [1, 2, 3]
[shapes.link3]
capsules = [{ a = [0, 0, 0], b = [0, 0, 2], radius = 0.25 }, { a = [0, 0, 5], b = [0, 0, 5], radius = 1 }]
[shapes]
link4 = { capsules = [] }
[[sensors]]
pattern = "ball"
[[sensors]]
pattern = "ring"
link = "link4"
centre = [0, 0, 0.5]
axis = [0, 0, 1]
radius = 0.1
count = 6
tilt_deg = 90
range = 0.4
[[sensors]]
pattern = "patch"
link = "turn3"
centre = [0, 0, 0]
along = [0.1, 0, 0]
across = [0, 0.1, 0]
columns = 2
rows = 3
[[sensors]]
pattern = "skin"
link = "link3"
spacing = 1
count = 5
)");
  const Robot& robot = file.robot;
  EXPECT_EQ(robot.links[0].name, "link2");
  EXPECT_EQ(robot.joint_count(), 4u);
  EXPECT_EQ(robot.links[robot.control_point.link].name, "link3");
  EXPECT_EQ(robot.control_point.position, Vector3d(1, 2, 3));
  EXPECT_DOUBLE_EQ(robot.ceilings.revolute_rad, std::numbers::pi / 90);
  EXPECT_TRUE(std::isinf(robot.ceilings.prismatic));
  EXPECT_DOUBLE_EQ((*file.start)[2], std::numbers::pi / 6);
  EXPECT_EQ(robot.links[2].body.size(), 2u);
  EXPECT_EQ(robot.links[4].body.size(), 0u);
  ASSERT_EQ(robot.sensors.size(), 26u + 6 + 6 + 3 * 5 + 5);
  EXPECT_EQ(robot.sensors[0].position, Vector3d(1, 2, 3));
  EXPECT_EQ(robot.sensors[0].range, 0.3);
  EXPECT_LT((robot.sensors[26].axis - Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_EQ(robot.sensors[26].range, 0.4);
  EXPECT_EQ(robot.links[robot.sensors[32].link].name, "turn3");
  EXPECT_EQ(robot.sensors[38].position.z(), 0);
}

TEST_F(RobotFileTest, PathsAreSoughtBesideTheFileAndWhereItSays) {
  std::filesystem::create_directory(path("elsewhere"));
  std::filesystem::rename(path("arm.urdf"), path("elsewhere/arm.urdf"));
  EXPECT_EQ(with_arm(""),
            "robot.toml:1: 'urdf' names a file that is not there: arm.urdf; it was sought beside this "
            "file: say where it is by --package-path DIR");
  EXPECT_EQ(with_arm("package_path = \"elsewhere\"\n"), "");
  EXPECT_EQ(with_arm("package_path = [\"nowhere\", \"elsewhere\"]\n"), "");
  EXPECT_NO_THROW(parse_robot("urdf = \"arm.urdf\"", path("robot.toml"), {path("elsewhere")}));
}

TEST_F(RobotFileTest, WhatIsWrongIsOneLineThatSaysWhere) {
  EXPECT_EQ(with_arm(""), "");
  EXPECT_EQ(complaint(""),
            "robot.toml:1: a robot file needs urdf = \"FILE.urdf\": the links and joints of the robot");
  EXPECT_TRUE(with_arm("\nspeed = 3\n")
                  .starts_with("robot.toml:3: unknown key 'speed'; known are: urdf, base, tip, "));
  EXPECT_EQ(with_arm("sensing_range = 0\n"), "robot.toml:2: 'sensing_range' must be a number more than 0");
  EXPECT_EQ(with_arm("start = [1, 2]\n"), "robot.toml:2: 'start' must be a list of 6 numbers");
  EXPECT_EQ(with_arm("package_path = 3\n"),
            "robot.toml:2: 'package_path' must be a text in quotes, or a list of them");
  EXPECT_EQ(with_arm("[control_point]\nlink = \"hand\"\n"),
            "robot.toml:3: 'link' in [control_point] is no link of the robot; its links are link1, turn2, "
            "link2, turn3, "
            "link3, turn4, link4");
  EXPECT_EQ(with_arm("[shapes.link2]\n"), "robot.toml:2: [shapes.link2] needs one of these keys: capsules");
  EXPECT_EQ(with_arm("[shapes.link2]\ncapsules = [{ a = [0, 0, 0], b = [1, 0, 0], radius = -1 }]\n"),
            "robot.toml:3: 'radius' in [shapes.link2.capsules] must be a number of 0 or more");
  EXPECT_NE(with_arm("[shapes.hand]\ncapsules = []\n").find("a shape is given for 'hand'"),
            std::string::npos);
  EXPECT_NE(with_arm("[locked]\njoint2a = 1\n").find("joint 'joint2a': is on the chain"), std::string::npos);
  const auto expect_unfit = [&](const std::string& more, const std::string& key, const std::string& what) {
    const std::string said = with_arm("\n" + more);
    EXPECT_TRUE(said.starts_with("robot.toml:" + key + " does not fit ")) << said;
    EXPECT_NE(said.find("arm.urdf: " + what), std::string::npos) << said;
  };
  expect_unfit("tip = \"hand\"\n", "3: 'tip'", "has no link 'hand' to be the tip");
  expect_unfit("base = \"hand\"\n", "3: 'base'", "has no link 'hand' to be the base");
  expect_unfit("[shapes.hand]\ncapsules = []\n", "3: 'hand' in [shapes]", "a shape is given for 'hand'");
  expect_unfit("[locked]\njoint9 = 1\n", "4: 'joint9' in [locked]", "a position is given for 'joint9'");
  expect_unfit("[locked_deg]\njoint2a = 1\n", "4: 'joint2a' in [locked_deg]",
               "joint 'joint2a': is on the chain");
}

TEST_F(RobotFileTest, WrongSensorsAreOneLineThatSaysWhere) {
  EXPECT_EQ(with_sensors("pattern = \"ball\"\n"), "");
  EXPECT_EQ(
      with_sensors("pattern = \"cloud\"\n"),
      "robot.toml:3: 'pattern' in [sensors] must be \"ball\", \"patch\", \"ring\", \"rings\" or \"skin\"");
  EXPECT_EQ(with_sensors("pattern = \"ball\"\nlink = \"hand\"\n").substr(0, 60),
            "robot.toml:4: 'link' in [sensors] is no link of the robot; i");
  EXPECT_EQ(
      with_sensors("pattern = \"ball\"\nradius = 1\n"),
      "robot.toml:4: unknown key 'radius' in [sensors]; known are: pattern, link, range, centre, without, "
      "without_deg");
  EXPECT_EQ(with_sensors("pattern = \"ring\"\n"), "robot.toml:2: [sensors] needs one of these keys: centre");
  EXPECT_EQ(with_sensors("pattern = \"ring\"\ncentre = [0, 0, 0]\naxis = [0, 0, 0]\nradius = 1\ncount = 3\n"),
            "robot.toml:2: the axis of a ring must be a finite vector that is not zero");
  EXPECT_EQ(with_sensors("pattern = \"ring\"\ncentre = [0, 0, 0]\naxis = [0, 0, 1]\nradius = 1\ncount = 0\n"),
            "robot.toml:7: 'count' in [sensors] must be a whole number of 1 or more, up to 100000");
  EXPECT_EQ(with_sensors("pattern = \"skin\"\nlink = \"link2\"\nspacing = 1e-9\n"),
            "robot.toml:2: the spacing of a skin is too small for its link");
}

TEST_F(RobotFileTest, TheCommandRefusesBadFilesInOneLine) {
  const auto follow = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"follow", "cube", "-o", path("m.limpet"), "--robot"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  };
  expect_refused(follow({"snake"}), "snake: give point, arm");
  expect_refused(follow({path("none.urdf")}), "none.urdf: cannot be opened");
  expect_refused(follow({path("none.toml")}), "none.toml: cannot be opened");
  expect_refused(follow({write("a.urdf", "<robot")}), "a.urdf:1: is damaged as XML");
  expect_refused(follow({write("b.urdf", "<robot name=\"r\"><link/></robot>")}), "b.urdf: is no sound URDF");
  expect_refused(follow({write("c.toml", "urdf = 3")}), "c.toml:1: 'urdf' must be a text in quotes");
  const std::string mesh = "<collision><geometry><mesh filename=\"FILE\"/></geometry></collision>";
  const auto with_mesh = [&](const std::string& file) {
    std::string text = read(kRobots + "arm.urdf"), shape = mesh;
    shape.replace(shape.find("FILE"), 4, file);
    return write("d.urdf", text.replace(text.find("<link name=\"turn2\"/>"), 20,
                                        "<link name=\"turn2\">" + shape + "</link>"));
  };
  expect_refused(follow({with_mesh("package://p/no.stl")}),
                 "link 'turn2': its mesh 'package://p/no.stl' is not there");
  write("bad.stl", "solid\n");
  expect_refused(follow({with_mesh("bad.stl")}), "link 'turn2': its mesh cannot be read");
  write("bad.dae", "<COLLADA/>");
  expect_refused(follow({with_mesh("bad.dae"), "--package-path", path("")}),
                 "link 'turn2': its mesh cannot be read");
}

}  // namespace
}  // namespace limpet::app
