// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <fstream>
#include <iterator>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <kdl/tree.hpp>
#include <limpet/kinematics/arm.hpp>
#include <limpet/kinematics/mesh_path.hpp>
#include <limpet/kinematics/reach.hpp>
#include <limpet/kinematics/urdf.hpp>
#include <limpet/simulation/mesh.hpp>
#include <numbers>

#include "../data_folder.hpp"
#include "capsules.hpp"
#include "corners.hpp"
#include "robots.hpp"

namespace limpet::kinematics {
namespace {

using Eigen::Vector3d;

struct RealRobot {
  std::string file, base, tip;
  std::vector<std::string> without_mesh{};  ///< links whose meshes are not in the data
};

std::ostream& operator<<(std::ostream& out, const RealRobot& robot) { return out << robot.file; }

class RealRobotTest : public ::testing::TestWithParam<RealRobot> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(path())) GTEST_SKIP() << "no " << path();
    options_.base = GetParam().base;
    options_.tip = GetParam().tip;
    for (const char* folder : {"robot_panda", "robot_ur5"})
      options_.package_paths.push_back((limpet::testing::data_folder() / folder).string());
    options_.load_mesh = [](const std::string& mesh) {
      return testing::corners_of(simulation::load_mesh(mesh));
    };
    for (const std::string& link : GetParam().without_mesh) options_.shapes[link] = {};
    robot_ = read_urdf(path(), options_);
  }

  static std::string path() {
    return (limpet::testing::data_folder() / "robot_urdf" / GetParam().file).string();
  }

  static urdf::ModelInterfaceSharedPtr document() {
    std::ifstream stream(path());
    return urdf::parseURDF({std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()});
  }

  /// Within the limits, or within a turn where there are none.
  Configuration random_configuration(survey::Random& random) const {
    Configuration at(static_cast<Eigen::Index>(robot_.joint_count()));
    Eigen::Index joint = 0;
    for (const Link& link : robot_.links)
      if (link.joint.kind != Joint::Kind::fixed)
        at[joint++] = random.uniform(std::max(link.joint.low, -3.0), std::min(link.joint.high, 3.0));
    return at;
  }

  UrdfOptions options_;
  Robot robot_;
};

INSTANTIATE_TEST_SUITE_P(All, RealRobotTest,
                         ::testing::Values(RealRobot{"panda.urdf", "panda_link0", "panda_hand_tcp"},
                                           RealRobot{"panda_collision.urdf", "panda_link0", "panda_hand_tcp"},
                                           RealRobot{"ur5_robot.urdf", "world", "tool0"},
                                           RealRobot{"ur5_joint_limited_robot.urdf", "base_link", "ee_link"},
                                           RealRobot{"iiwa14_primitive_collision.urdf",
                                                     "base",
                                                     "iiwa_link_ee",
                                                     {"iiwa_link_6", "iiwa_link_7"}}));

/// KDL's chain of the same file, by way of its own frames and joints.
KDL::Chain kdl_chain(const urdf::ModelInterface& model, const std::string& base, const std::string& tip) {
  std::vector<urdf::JointConstSharedPtr> joints;
  for (auto link = model.getLink(tip); link->name != base;
       link = model.getLink(link->parent_joint->parent_link_name))
    joints.insert(joints.begin(), link->parent_joint);
  KDL::Chain chain;
  for (const auto& joint : joints) {
    const urdf::Pose& pose = joint->parent_to_joint_origin_transform;
    double roll = 0, pitch = 0, yaw = 0;
    pose.rotation.getRPY(roll, pitch, yaw);
    const KDL::Frame frame(KDL::Rotation::RPY(roll, pitch, yaw),
                           KDL::Vector(pose.position.x, pose.position.y, pose.position.z));
    const KDL::Vector axis = frame.M * KDL::Vector(joint->axis.x, joint->axis.y, joint->axis.z);
    const bool turns = joint->type == urdf::Joint::REVOLUTE || joint->type == urdf::Joint::CONTINUOUS;
    const KDL::Joint to = joint->type == urdf::Joint::FIXED ? KDL::Joint(KDL::Joint::None)
                          : turns ? KDL::Joint(joint->name, frame.p, axis, KDL::Joint::RotAxis)
                                  : KDL::Joint(joint->name, frame.p, axis, KDL::Joint::TransAxis);
    chain.addSegment(KDL::Segment(joint->child_link_name, to, frame));
  }
  return chain;
}

TEST_P(RealRobotTest, IsWhereOrocosKdlHasIt) {
  const KDL::Chain chain = kdl_chain(*document(), GetParam().base, GetParam().tip);
  ASSERT_EQ(chain.getNrOfJoints(), robot_.joint_count());
  KDL::ChainFkSolverPos_recursive forward(chain);
  KDL::ChainJntToJacSolver jacobian_of(chain);
  survey::Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const Configuration at = random_configuration(random);
    KDL::JntArray q(chain.getNrOfJoints());
    q.data = at;
    KDL::Frame end;
    KDL::Jacobian jacobian(chain.getNrOfJoints());
    ASSERT_GE(forward.JntToCart(q, end), 0);
    ASSERT_GE(jacobian_of.JntToJac(q, jacobian), 0);
    const Posture posture(robot_, at);
    const Eigen::Isometry3d& tip = posture.link(robot_.control_point.link);
    for (int row = 0; row < 3; ++row) {
      EXPECT_NEAR(tip.translation()[row], end.p[row], 1e-9);
      for (int column = 0; column < 3; ++column)
        EXPECT_NEAR(tip.linear()(row, column), end.M(row, column), 1e-9);
    }
    EXPECT_LT((posture.jacobian() - jacobian.data.topRows<3>()).norm(), 1e-9);
  }
}

TEST_P(RealRobotTest, JacobianIsTheDerivativeOfTheControlPoint) {
  survey::Random random(2);
  const double h = 1e-6;
  for (int trial = 0; trial < 50; ++trial) {
    const Configuration at = random_configuration(random);
    const Eigen::Matrix3Xd jacobian = Posture(robot_, at).jacobian();
    for (Eigen::Index j = 0; j < at.size(); ++j) {
      const Configuration step = h * Configuration::Unit(at.size(), j);
      const Vector3d difference =
          (Posture(robot_, at + step).control_point() - Posture(robot_, at - step).control_point()) / (2 * h);
      EXPECT_LT((jacobian.col(j) - difference).norm(), 1e-8);
    }
  }
}

TEST_P(RealRobotTest, MovesAsFarAsItsMakerSays) {
  EXPECT_EQ(robot_.joint_count(), GetParam().file.starts_with("ur5") ? 6u : 7u);
  for (const Link& link : robot_.links) {
    if (link.joint.kind == Joint::Kind::fixed) continue;
    EXPECT_TRUE(std::isfinite(link.joint.low) && std::isfinite(link.joint.high)) << link.name;
    EXPECT_TRUE(std::isfinite(link.joint.max_velocity)) << link.name;
  }
  const double reach = largest_reach(robot_);
  EXPECT_GT(reach, 0.8);
  EXPECT_LT(reach, 2);
  RecordProperty("reach_mm", static_cast<int>(1000 * reach));
}

/// Points of a shape's surface, in its own frame, that its capsules must hold.
std::vector<Vector3d> points_of(const urdf::Geometry& geometry, const UrdfOptions& options,
                                const std::string& beside) {
  std::vector<Vector3d> points;
  if (geometry.type == urdf::Geometry::MESH) {
    const auto& mesh = static_cast<const urdf::Mesh&>(geometry);
    for (const Vector3d& p : testing::corners_of(
             simulation::load_mesh(*find_robot_file(mesh.filename, beside, options.package_paths))))
      points.push_back(p.cwiseProduct(Vector3d(mesh.scale.x, mesh.scale.y, mesh.scale.z)));
  } else if (geometry.type == urdf::Geometry::BOX) {
    const auto& box = static_cast<const urdf::Box&>(geometry);
    for (int i = 0; i < 8; ++i)
      points.emplace_back(Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)
                              .cwiseProduct(Vector3d(box.dim.x, box.dim.y, box.dim.z) / 2));
  } else if (geometry.type == urdf::Geometry::SPHERE) {
    const double r = static_cast<const urdf::Sphere&>(geometry).radius;
    for (int i = 0; i < 3; ++i) points.insert(points.end(), {r * Vector3d::Unit(i), -r * Vector3d::Unit(i)});
  } else {
    const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
    for (int i = 0; i < 64; ++i)
      for (const double z : {-cylinder.length / 2, cylinder.length / 2})
        points.emplace_back(cylinder.radius * std::cos(i * 0.1), cylinder.radius * std::sin(i * 0.1), z);
  }
  return points;
}

TEST_P(RealRobotTest, CapsulesHoldAllCollisionShapes) {
  const auto model = document();
  const std::string beside = std::filesystem::path(path()).parent_path().string();
  double farthest = 0;
  for (const Link& link : robot_.links) {
    if (options_.shapes.contains(link.name)) continue;
    std::vector<Vector3d> all;
    for (const auto& collision : model->getLink(link.name)->collision_array) {
      const urdf::Pose& pose = collision->origin;
      const Eigen::Quaterniond turn(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z);
      for (const Vector3d& p : points_of(*collision->geometry, options_, beside)) {
        all.push_back(turn * p + Vector3d(pose.position.x, pose.position.y, pose.position.z));
        bool is_in = false;
        for (const model::Capsule& part : link.body) is_in |= testing::depth_in(all.back(), part) > -1e-12;
        EXPECT_TRUE(is_in) << link.name << " " << all.back().transpose();
      }
    }
    EXPECT_EQ(all.empty(), link.body.empty()) << link.name;
    if (all.empty()) continue;
    double here = 0;
    for (const model::Capsule& part : link.body) here = std::max(here, testing::excess(part, all));
    farthest = std::max(farthest, here);
    if (std::getenv("LIMPET_SAY"))
      std::printf("%s %s: %zu capsules, %.1f mm beyond the hull\n", GetParam().file.c_str(),
                  link.name.c_str(), link.body.size(), 1000 * here);
  }
  EXPECT_LT(farthest, 0.15);
}

TEST(Panda, FingersAreLockedWhereTheyAreSaidToBe) {
  const std::string path = (limpet::testing::data_folder() / "robot_urdf/panda_collision.urdf").string();
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  UrdfOptions options;
  options.tip = "panda_hand_tcp";
  options.locked["panda_finger_joint1"] = 0.04;
  const Robot robot = read_urdf(path, options);
  for (const Link& link : robot.links) {
    const double at = link.mounting.translation().y();
    if (link.name.ends_with("finger")) {
      EXPECT_NEAR(at, link.name == "panda_leftfinger" ? 0.04 : -0.04, 1e-15);
    }
  }
  EXPECT_EQ(robot.joint_count(), 7u);
}

}  // namespace
}  // namespace limpet::kinematics
