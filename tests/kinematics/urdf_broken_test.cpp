// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/kinematics/urdf.hpp>

#include "../temporary_folder.hpp"
#include "robots.hpp"
#include "urdf_text.hpp"

namespace limpet::kinematics {
namespace {

using testing::joint;
using testing::link;
using testing::robot_of;
using testing::shape;

/// What is said of a file, and nothing on the console; empty: it is fine.
std::string urdf_complaint(const std::string& text, const UrdfOptions& options = {}) {
  ::testing::internal::CaptureStderr();
  ::testing::internal::CaptureStdout();
  std::string what;
  try {
    parse_urdf(text, "robot.urdf", options);
  } catch (const RobotError& error) {
    what = error.what();
    EXPECT_TRUE(what.starts_with("robot.urdf:")) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  return what;
}

/// A sound robot of two links, a and b, with this in them, or with another joint.
std::string two_links(const std::string& in_a,
                      const std::string& between = joint("ab", "continuous", "a", "b")) {
  return robot_of(link("a", in_a) + link("b") + between);
}

const std::string kLimits = R"(<limit lower="-1" upper="1" velocity="1" effort="1"/>)";

TEST(BrokenUrdf, AsXml) {
  EXPECT_EQ(urdf_complaint(two_links("")), "");
  EXPECT_EQ(urdf_complaint(""), "robot.urdf:1: is damaged as XML: Error document empty");
  EXPECT_EQ(urdf_complaint("hello"), "robot.urdf:1: is damaged as XML: Error document empty");
  EXPECT_TRUE(urdf_complaint("<robot name=\"r\">\n<link name=\"a\">\n</robot>")
                  .starts_with("robot.urdf:3: is damaged as XML: "));
  EXPECT_EQ(urdf_complaint("<model/>"),
            "robot.urdf: is no URDF: it has no <robot>; a .xacro file must be expanded first");
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "<a>";
  EXPECT_EQ(urdf_complaint(deep), "robot.urdf: its elements are too deep in each other; this is no URDF");
}

TEST(BrokenUrdf, AsATree) {
  const std::string links = link("a") + link("b") + link("c");
  EXPECT_EQ(urdf_complaint("<robot name=\"r\"/>"),
            "robot.urdf: is no sound URDF: No link elements found in urdf file");
  EXPECT_EQ(urdf_complaint("<robot><link name=\"a\"/></robot>"),
            "robot.urdf: is no sound URDF: No name given for the robot");
  EXPECT_EQ(urdf_complaint(robot_of(link("a") + link("a"))),
            "robot.urdf: is no sound URDF: link 'a' is not unique");
  EXPECT_NE(urdf_complaint(robot_of("<link/>")), "");
  EXPECT_NE(urdf_complaint(robot_of(links + joint("ab", "continuous", "a", "b"))).find("Two root links"),
            std::string::npos);
  EXPECT_NE(urdf_complaint(robot_of(link("a") + link("b") + joint("ab", "fixed", "a", "b") +
                                    joint("ba", "fixed", "b", "a")))
                .find("No root link"),
            std::string::npos);
  EXPECT_EQ(urdf_complaint(robot_of(links + joint("ac", "continuous", "a", "c") +
                                    joint("bc", "fixed", "b", "c") + joint("ab", "fixed", "a", "b"))),
            "robot.urdf: link 'c' is the child of more than one joint, or carries itself");
  EXPECT_NE(urdf_complaint(robot_of(link("a") + joint("ab", "continuous", "a", "b"))).find("[b]"),
            std::string::npos);
  EXPECT_NE(urdf_complaint(two_links("", "<joint name=\"j\" type=\"fixed\"><parent link=\"a\"/></joint>")),
            "");
}

TEST(BrokenUrdf, InItsJoints) {
  const auto with = [](const std::string& type, const std::string& inside) {
    return urdf_complaint(two_links("", joint("ab", type, "a", "b", inside)));
  };
  EXPECT_EQ(with("revolute", kLimits), "");
  EXPECT_NE(with("revolute", "").find("ab"), std::string::npos);
  EXPECT_NE(with("", "").find("ab"), std::string::npos);
  EXPECT_NE(with("helical", kLimits).find("ab"), std::string::npos);
  for (const std::string type : {"planar", "floating"})
    EXPECT_EQ(with(type, ""),
              "robot.urdf: joint 'ab': is planar, floating or of no known type; a robot here has fixed, "
              "prismatic, revolute and continuous joints");
  EXPECT_EQ(with("continuous", "<axis xyz=\"0 0 0\"/>"),
            "robot.urdf: joint 'ab': its axis is zero: give it a direction");
  EXPECT_NE(with("continuous", "<axis xyz=\"0 nan 1\"/>"), "");
  EXPECT_NE(with("continuous", "<axis xyz=\"0 1\"/>"), "");
  EXPECT_NE(with("continuous", "<origin xyz=\"0 1e400 1\"/>"), "");
  EXPECT_EQ(with("revolute", R"(<limit lower="1" upper="-1" velocity="1" effort="1"/>)"),
            "robot.urdf: joint 'ab': its limits are out of order");
  EXPECT_EQ(
      with("revolute", R"(<limit lower="0" upper="0" velocity="1" effort="1"/>)"),
      "robot.urdf: joint 'ab': its limits are equal, so that it cannot move: give its limits, or make it "
      "fixed");
  EXPECT_EQ(with("revolute", R"(<limit lower="-1" upper="1" velocity="-1" effort="1"/>)"),
            "robot.urdf: joint 'ab': its velocity limit is negative");
  EXPECT_EQ(with("revolute", kLimits + "<mimic joint=\"cd\"/>"),
            "robot.urdf: joint 'ab': mimics 'cd': on the chain to the tip each joint moves by itself");
  EXPECT_EQ(with("fixed", ""), "robot.urdf: no joint between 'a' and 'b' moves: name another base or tip");
}

TEST(BrokenUrdf, InItsShapes) {
  EXPECT_EQ(urdf_complaint(two_links(shape("<sphere radius=\"1\"/>"))), "");
  for (const std::string geometry : {R"(<sphere/>)", R"(<sphere radius="big"/>)", R"(<cylinder radius="1"/>)",
                                     R"(<box size="1 1"/>)", R"(<cone/>)", R"(<mesh/>)", R"()"})
    EXPECT_NE(urdf_complaint(two_links(shape(geometry))).find("Link [a]"), std::string::npos) << geometry;
  EXPECT_EQ(
      urdf_complaint(two_links(shape(R"(<sphere radius="-1"/>)"))),
      "robot.urdf: link 'a': the sizes of its collision shapes must not be negative: the radius of a sphere");
  EXPECT_EQ(urdf_complaint(two_links(shape(R"(<mesh filename="package://p/a.stl"/>)"))),
            "robot.urdf: link 'a': its mesh 'package://p/a.stl' is not there: say by a package path in which "
            "folder it is, or give the link's shape in a robot file, as capsules in [shapes.a]");
}

class BrokenUrdfMeshTest : public limpet::testing::TemporaryFolder {};

TEST_F(BrokenUrdfMeshTest, IsNamedWithItsLink) {
  const std::string mesh = write("a.stl", "");
  const std::string text = two_links(shape("<mesh filename=\"" + mesh + "\"/>"));
  UrdfOptions options;
  EXPECT_EQ(urdf_complaint(text),
            "robot.urdf: link 'a': its shape is the mesh '" + mesh + "', and meshes are not read here");
  options.load_mesh = [](const std::string& path) -> std::vector<Eigen::Vector3d> {
    throw std::runtime_error(path + ": is empty");
  };
  EXPECT_EQ(urdf_complaint(text, options),
            "robot.urdf: link 'a': its mesh cannot be read: " + mesh +
                ": is empty; mend it, or give the link's shape in a robot file, as "
                "capsules in [shapes.a]");
  options.load_mesh = [](const std::string&) { return std::vector<Eigen::Vector3d>{}; };
  EXPECT_EQ(urdf_complaint(text, options), "robot.urdf: link 'a': the mesh '" + mesh + "' has no triangles");
}

TEST(BrokenUrdf, InWhatIsAskedOfIt) {
  const std::string text = robot_of(link("a") + link("b") + link("c") + joint("ab", "continuous", "a", "b") +
                                    joint("ac", "revolute", "a", "c", kLimits));
  EXPECT_EQ(
      urdf_complaint(text),
      "robot.urdf: which link is the tip? b, c are equally far from 'a': name one as tip in a robot file "
      "(.toml)");
  EXPECT_EQ(urdf_complaint(text, {.tip = "b"}), "");
  EXPECT_EQ(urdf_complaint(text, {.tip = "d"}),
            "robot.urdf: has no link 'd' to be the tip; its links are a, b, c");
  EXPECT_EQ(urdf_complaint(text, {.base = "d"}),
            "robot.urdf: has no link 'd' to be the base; its links are a, b, c");
  EXPECT_EQ(urdf_complaint(text, {.base = "b", .tip = "c"}),
            "robot.urdf: the base 'b' does not carry the tip 'c'");
  EXPECT_EQ(urdf_complaint(text, {.base = "b"}),
            "robot.urdf: no joint between 'b' and 'b' moves: name another base or tip");
  EXPECT_EQ(urdf_complaint(text, {.tip = "b", .locked = {{"ac", 2}}}),
            "robot.urdf: joint 'ac': the position given for it is outside its limits");
  EXPECT_EQ(urdf_complaint(text, {.tip = "b", .locked = {{"ad", 2}}}),
            "robot.urdf: a position is given for 'ad', which is no joint");
  EXPECT_EQ(
      urdf_complaint(text, {.tip = "b", .locked = {{"ab", 0}}}),
      "robot.urdf: joint 'ab': is on the chain to the tip, where joints move: no position can be given for "
      "it");
  EXPECT_EQ(urdf_complaint(text, {.tip = "b", .shapes = {{"d", {}}}}),
            "robot.urdf: a shape is given for 'd', which is no link that 'a' carries");
}

TEST(BrokenUrdf, FilesThatAreNone) {
  EXPECT_THROW(read_urdf("/no/such/robot.urdf", {}), RobotError);
  EXPECT_THROW(read_urdf("/", {}), RobotError);
}

TEST(BrokenUrdf, DamagedFilesAreRobotsOrErrorsInOneLine) {
  const std::string whole = two_links(shape("<sphere radius=\"1\"/>") + shape("<box size=\"1 2 3\"/>"),
                                      joint("ab", "revolute", "a", "b", kLimits + "<axis xyz=\"0 0 1\"/>"));
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
          text.insert(at, 1, "<>/=\"' -\n#0e."[random.below(13)]);
      }
    }
    refused += !urdf_complaint(text).empty();
  }
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace limpet::kinematics
