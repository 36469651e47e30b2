// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/kinematics/mesh_path.hpp>

#include "../temporary_folder.hpp"

namespace limpet::kinematics {
namespace {

class MeshPathTest : public limpet::testing::TemporaryFolder {
 protected:
  /// An empty file, its folders made for it.
  std::string touch(const std::string& name) const {
    std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
    return write(name, "");
  }
  std::string find(const std::string& name, const std::vector<std::string>& folders = {}) const {
    return find_robot_file(name, path("robot/urdf"), folders).value_or("");
  }
};

TEST_F(MeshPathTest, AbsoluteAndBesideTheFile) {
  const std::string file = touch("robot/urdf/link.stl");
  EXPECT_EQ(find("link.stl"), file);
  EXPECT_EQ(find(file), file);
  EXPECT_EQ(find("file://" + file), file);
  EXPECT_EQ(find("../urdf/link.stl"), file);
  EXPECT_EQ(find("other.stl"), "");
  EXPECT_EQ(find(""), "");
  EXPECT_EQ(find("package://"), "");
  EXPECT_EQ(find(path("robot")), "");  // a folder
}

TEST_F(MeshPathTest, InPackageFoldersWithFewerAndFewerParts) {
  const std::string whole = touch("ros/arm/meshes/link.stl"), inside = touch("elsewhere/arm/meshes/link.stl");
  const std::string flat = touch("flat/link.stl");
  const std::string name = "package://arm/meshes/link.stl";
  EXPECT_EQ(find(name), "");
  EXPECT_EQ(find(name, {path("ros")}), whole);                                // the folder of packages
  EXPECT_EQ(find(name, {path("elsewhere/arm")}), inside);                     // the package itself
  EXPECT_EQ(find(name, {path("ros/arm/meshes")}), whole);                     // by base name
  EXPECT_EQ(find(name, {path("nowhere"), path("flat"), path("ros")}), flat);  // in the order given
  EXPECT_EQ(find("model://arm/meshes/link.stl", {path("ros")}), whole);
  EXPECT_EQ(find("meshes/link.stl", {path("elsewhere/arm")}), inside);
}

TEST_F(MeshPathTest, WhereACheckoutHasPackages) {
  touch("robot/urdf/robot.urdf");
  const std::string mesh = touch("robot/meshes/link.stl");
  EXPECT_EQ(find("package://robot/meshes/link.stl"), mesh);
  EXPECT_EQ(find("robot/meshes/link.stl"), "");  // no package: what is meant is beside the file
}

}  // namespace
}  // namespace limpet::kinematics
