// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <limpet/following/links/link_guard.hpp>
#include <limpet/following/transit/cheapest_way.hpp>
#include <optional>
#include <utility>
#include <vector>

namespace limpet::following {

/// The configurations in which a robot has been, or which a plan has gone over, and between which of them it
/// can go straight in joint space (Kavraki et al. 1996). Lengths of ways are in steps, as the ceilings allow.
class Roadmap {
 public:
  struct Node {
    kinematics::Configuration at;
    Eigen::Vector3d place;  ///< of the control point
  };

  /// The guard must outlive it.
  explicit Roadmap(const LinkGuard& guard) : guard_(guard) {}

  /// The robot is here now, having come straight from where it was before; links to what is near are looked
  /// for.
  void arrive(const kinematics::Posture&, const Obstacles&);
  /// The same, but the node is where it is exactly: a new one, if need be.
  void arrive_exactly(const kinematics::Posture&);
  /// Adds a way that is clear, from a node on; where it comes to a node's very configuration, over that node.
  /// Returns the node at its end.
  std::size_t add_way(std::size_t from, const std::vector<kinematics::Configuration>& way);
  /// Motions to this node are dearer from now on: it could not be reached, this time.
  void block(std::size_t node);

  const std::vector<Node>& nodes() const { return nodes_; }
  std::size_t present() const { return present_; }
  /// The cheapest way from the present node to one that is wanted, both included; empty: there is none.
  std::vector<std::size_t> way_to(const std::function<bool(std::size_t)>& wanted) const;
  /// The nodes nearest to a configuration, the nearest first.
  std::vector<std::size_t> nearest(const kinematics::Configuration&, std::size_t most) const;
  /// How many steps the robot needs at least from one configuration to another.
  double steps(const kinematics::Configuration&, const kinematics::Configuration&) const;

 private:
  using Link = GraphLink;
  Link* find(std::size_t from, std::size_t to);
  void link(std::size_t, std::size_t);
  std::size_t add(const kinematics::Configuration&);

  const LinkGuard& guard_;
  std::vector<Node> nodes_;
  std::vector<std::vector<Link>> links_;
  std::size_t present_ = 0;
};

}  // namespace limpet::following
