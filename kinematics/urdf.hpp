// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <limpet/kinematics/robot.hpp>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace limpet::kinematics {

/// A robot's file that cannot be read, or that says what cannot be. what() is one line: which file, which
/// link or joint, what is wrong, and what to do about it where that is not plain.
class RobotError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One of UrdfOptions does not fit the file.
class UrdfOptionError : public RobotError {
 public:
  /// `key`: base, tip, locked or shapes. `name`: of the joint that is locked, or the link that has a shape.
  UrdfOptionError(const std::string& what, std::string key, std::string name)
      : RobotError(what), key_(std::move(key)), name_(std::move(name)) {}
  const std::string& key() const { return key_; }
  const std::string& name() const { return name_; }

 private:
  std::string key_, name_;
};

/// Reads a mesh: the corners of its triangles, three after three, in its own frame and unit. What it throws
/// is a std::exception that says in one line what is wrong.
using MeshLoader = std::function<std::vector<Eigen::Vector3d>(const std::string& path)>;

/// What of a URDF is wanted, and what it does not say itself.
struct UrdfOptions {
  std::string base{};  ///< link that stands still in the world; empty: the root
  /// Link at the end of the chain. Empty: the one that is named as the tip of an arm is (tcp, tool0, ee,
  /// flange, hand, in this order, or ending so), if at least half of the joints that can move are on its
  /// chain; else the one with the most of these, and of several the farthest from the base, in links.
  std::string tip{};
  std::vector<std::string> package_paths{};  ///< where meshes are sought, as find_robot_file() does
  /// Positions of joints that are not on the chain, by name: they are locked there. One that is not named is
  /// locked at 0, or at the limit nearest to it, and one that mimics another where that one puts it.
  std::map<std::string, double> locked{};
  std::map<std::string, std::vector<model::Capsule>> shapes{};  ///< of links, by name: instead of the file's
  MeshLoader load_mesh{};                                       ///< needed where a shape is a mesh
};

/// The robot in a URDF file (http://wiki.ros.org/urdf/XML): all that the base link carries. The joints on the
/// chain from the base to the tip move it, as they are: fixed, prismatic, revolute, or continuous (revolute
/// without limits). All others are locked. Links are those of the chain in their order, then what is fixed to
/// it; frames, axes, limits and largest velocities (0, which some programs write, is none) are the file's,
/// the world is the base link's frame. The control point is the tip's origin; there are no sensors, and no
/// ceilings.
///
/// Collision shapes become capsules that hold them: a sphere is one; a cylinder becomes the capsule about its
/// axis, which goes beyond both of its ends by its radius; a box the smallest along one of its sides, no
/// point of it farther from the box than twice its radius; a mesh one or a few by enclosing_capsules(). A
/// `<capsule>` as Drake has it, like a cylinder, is taken, too. Capsules within others are left out. What is
/// for the eye (`<visual>`), masses and the like are not looked at.
///
/// Throws RobotError when the file cannot be read or is no URDF; when the tip is
/// to be chosen among several (UrdfOptionError: when base or tip are no links, or another option does not
/// fit); when a joint on the chain is planar, floating, mimics another, cannot move, or
/// none moves; and when a mesh is missing or damaged.
Robot read_urdf(const std::string& path, const UrdfOptions&);

/// The same for the text of a file. `path`: for messages, and for the files it names.
Robot parse_urdf(const std::string& text, const std::string& path, const UrdfOptions&);

}  // namespace limpet::kinematics
