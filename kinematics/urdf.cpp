// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/kinematics/urdf.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "urdf_bodies_internal.hpp"
#include "urdf_document_internal.hpp"
#include "urdf_tip_internal.hpp"

namespace limpet::kinematics {
namespace {

using LinkPointer = urdf::LinkConstSharedPtr;

/// A link as the base carries it.
struct Carried {
  LinkPointer link;
  std::size_t parent = 0;  ///< an earlier one; of the base itself nothing
  std::size_t depth = 0;   ///< links from the base
};

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

bool can_move(const urdf::Joint& joint) { return joint.type != urdf::Joint::FIXED; }

/// Makes a robot of one file.
class UrdfReader {
 public:
  UrdfReader(const std::string& text, const std::string& path, const UrdfOptions& options)
      : path_(path), options_(options), model_(internal::parse_document(text, path)) {}

  Robot read() {
    find_carried();
    const std::size_t tip = find_tip();
    require_known_names();
    Robot robot;
    robot.name = model_->getName();
    std::vector<std::size_t> index(carried_.size());  // of each carried link in the robot
    for (const std::size_t i : chain_first(tip)) {
      index[i] = robot.links.size();
      robot.links.push_back(to_link(i));
      if (i > 0) robot.links.back().parent = index[carried_[i].parent];
    }
    robot.control_point.link = index[tip];
    if (robot.joint_count() == 0)
      fail("no joint between '" + name_of(0) + "' and '" + name_of(tip) +
           "' moves: name another base or tip");
    try {
      require_sound(robot);
    } catch (const std::invalid_argument& error) {
      fail(error.what());
    }
    return robot;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw RobotError(path_ + ": " + what); }
  [[noreturn]] void fail_option(const std::string& key, const std::string& name,
                                const std::string& what) const {
    throw UrdfOptionError(path_ + ": " + what, key, name);
  }
  [[noreturn]] void fail_locked(const urdf::Joint& joint, const std::string& what) const {
    fail_option("locked", joint.name, "joint '" + joint.name + "': " + what);
  }
  [[noreturn]] void fail(const urdf::Joint& joint, const std::string& what) const {
    fail("joint '" + joint.name + "': " + what);
  }

  const std::string& name_of(std::size_t i) const { return carried_[i].link->name; }
  const urdf::Joint& joint_of(std::size_t i) const { return *carried_[i].link->parent_joint; }

  LinkPointer link_of_name(const std::string& name, const std::string& role) const {
    const LinkPointer link = model_->getLink(name);
    if (link) return link;
    std::vector<std::string> names;
    for (const auto& [known, unused] : model_->links_) names.push_back(known);
    fail_option(role, "",
                "has no link '" + name + "' to be the " + role + "; its links are " + listed(names));
  }

  /// All links that the base carries, each after its parent, what hangs on one link together.
  void find_carried() {
    const LinkPointer base = options_.base.empty() ? model_->getRoot() : link_of_name(options_.base, "base");
    std::set<std::string> met;
    std::vector<Carried> open = {{base, 0, 0}};
    while (!open.empty()) {
      const Carried next = open.back();
      open.pop_back();
      if (!met.insert(next.link->name).second)
        fail("link '" + next.link->name + "' is the child of more than one joint, or carries itself");
      const auto& children = next.link->child_links;
      for (auto child = children.rbegin(); child != children.rend(); ++child)
        open.push_back({*child, carried_.size(), next.depth + 1});
      carried_.push_back(next);
    }
  }

  std::size_t find_tip() const {
    if (options_.tip.empty()) return chosen_tip();
    link_of_name(options_.tip, "tip");
    for (std::size_t i = 0; i < carried_.size(); ++i)
      if (name_of(i) == options_.tip) return i;
    fail_option("tip", "", "the base '" + name_of(0) + "' does not carry the tip '" + options_.tip + "'");
  }

  std::size_t chosen_tip() const {
    const std::vector<std::size_t> best = internal::likely_tips(tip_candidates());
    if (best.size() == 1) return best.front();
    std::vector<std::string> names;
    for (const std::size_t i : best) names.push_back(name_of(i));
    fail("which link is the tip? " + listed(names) + " are equally far from '" + name_of(0) +
         "': name one as tip in a robot file (.toml)");
  }

  std::vector<internal::TipCandidate> tip_candidates() const {
    std::vector<internal::TipCandidate> candidates;
    for (std::size_t i = 0; i < carried_.size(); ++i) {
      const bool moves = i > 0 && can_move(joint_of(i)) && !joint_of(i).mimic;
      const std::size_t before = i > 0 ? candidates[carried_[i].parent].moving_joints : 0;
      candidates.push_back({name_of(i), carried_[i].depth, before + moves});
    }
    return candidates;
  }

  /// What the options name must be there: a slip of the pen in a name would go unseen.
  void require_known_names() const {
    for (const auto& [name, shape] : options_.shapes) {
      const auto is_it = [&name = name](const Carried& one) { return one.link->name == name; };
      if (std::none_of(carried_.begin(), carried_.end(), is_it))
        fail_option(
            "shapes", name,
            "a shape is given for '" + name + "', which is no link that '" + name_of(0) + "' carries");
    }
    for (const auto& [name, position] : options_.locked) {
      if (!model_->getJoint(name))
        fail_option("locked", name, "a position is given for '" + name + "', which is no joint");
      if (!std::isfinite(position))
        fail_option("locked", name, "the position of joint '" + name + "' must be finite");
    }
  }

  /// The chain from the base to the tip, then all other links.
  std::vector<std::size_t> chain_first(std::size_t tip) {
    on_chain_.assign(carried_.size(), false);
    on_chain_[0] = true;
    for (std::size_t i = tip; i > 0; i = carried_[i].parent) on_chain_[i] = true;
    std::vector<std::size_t> order(carried_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_partition(order.begin(), order.end(), [&](std::size_t i) { return on_chain_[i]; });
    return order;
  }

  Link to_link(std::size_t i) const {
    Link link;
    link.name = name_of(i);
    link.body = internal::body_of(*carried_[i].link, path_, options_);
    if (i == 0) return link;  // the base stands where the world does
    const urdf::Joint& joint = joint_of(i);
    link.mounting = internal::to_pose(joint.parent_to_joint_origin_transform);
    if (on_chain_[i]) {
      link.joint = chain_joint(joint);
    } else if (can_move(joint)) {
      link.mounting = link.mounting * motion_of(to_joint(joint), locked_position(joint));
    }
    return link;
  }

  Joint chain_joint(const urdf::Joint& joint) const {
    if (options_.locked.contains(joint.name))
      fail_locked(joint, "is on the chain to the tip, where joints move: no position can be given for it");
    if (joint.mimic)
      fail(joint,
           "mimics '" + joint.mimic->joint_name + "': on the chain to the tip each joint moves by itself");
    const Joint found = to_joint(joint);
    if (found.kind != Joint::Kind::fixed && found.low == found.high)
      fail(joint, "its limits are equal, so that it cannot move: give its limits, or make it fixed");
    return found;
  }

  Joint to_joint(const urdf::Joint& joint) const {
    Joint to;
    switch (joint.type) {
      case urdf::Joint::FIXED:
        return to;
      case urdf::Joint::PRISMATIC:
        to.kind = Joint::Kind::prismatic;
        break;
      case urdf::Joint::REVOLUTE:
      case urdf::Joint::CONTINUOUS:
        to.kind = Joint::Kind::revolute;
        break;
      default:
        fail(joint,
             "is planar, floating or of no known type; a robot here has fixed, prismatic, revolute and "
             "continuous joints");
    }
    const Eigen::Vector3d axis = internal::to_vector(joint.axis);
    if (!(axis.norm() > 0)) fail(joint, "its axis is zero: give it a direction");
    to.axis = axis.normalized();
    if (joint.limits) {
      if (joint.limits->velocity < 0) fail(joint, "its velocity limit is negative");
      if (joint.limits->velocity > 0) to.max_velocity = joint.limits->velocity;
    }
    if (joint.type == urdf::Joint::CONTINUOUS) return to;
    if (!joint.limits) fail(joint, "has no limits: give them, or make it continuous");
    if (!(joint.limits->lower <= joint.limits->upper)) fail(joint, "its limits are out of order");
    to.low = joint.limits->lower, to.high = joint.limits->upper;
    return to;
  }

  double locked_position(const urdf::Joint& joint, int mimics = 0) const {
    const Joint limits = to_joint(joint);
    if (const auto given = options_.locked.find(joint.name); given != options_.locked.end()) {
      if (given->second < limits.low || given->second > limits.high)
        fail_locked(joint, "the position given for it is outside its limits");
      return given->second;
    }
    if (!joint.mimic) return std::clamp(0.0, limits.low, limits.high);
    const auto other = model_->getJoint(joint.mimic->joint_name);
    if (!other) fail(joint, "mimics '" + joint.mimic->joint_name + "', which is no joint");
    if (mimics > 10) fail(joint, "mimics a joint that mimics it");
    if (moves_on_chain(*other))
      fail(joint, "mimics '" + other->name + "', which moves: give a position at which it is locked");
    const double leader = can_move(*other) ? locked_position(*other, mimics + 1) : 0.0;
    return joint.mimic->multiplier * leader + joint.mimic->offset;
  }

  bool moves_on_chain(const urdf::Joint& joint) const {
    for (std::size_t i = 1; i < carried_.size(); ++i)
      if (on_chain_[i] && &joint_of(i) == &joint) return can_move(joint);
    return false;
  }

  const std::string& path_;
  const UrdfOptions& options_;
  const urdf::ModelInterfaceSharedPtr model_;
  std::vector<Carried> carried_;  ///< the base first
  std::vector<bool> on_chain_;    ///< of each
};

}  // namespace

Robot parse_urdf(const std::string& text, const std::string& path, const UrdfOptions& options) {
  return UrdfReader(text, path, options).read();
}

Robot read_urdf(const std::string& path, const UrdfOptions& options) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) throw RobotError(path + ": is a folder");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw RobotError(path + ": cannot be opened");
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  return parse_urdf(text, path, options);
}

}  // namespace limpet::kinematics
