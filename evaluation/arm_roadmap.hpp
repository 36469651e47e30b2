// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstddef>
#include <limpet/kinematics/posture.hpp>
#include <vector>

namespace limpet::evaluation {

/// Configurations of a robot, and which of them are joined by a clear way that is straight in joint space (a
/// probabilistic roadmap: Kavraki, Švestka, Latombe, Overmars 1996). Node 0 is the start.
///
/// A joint that turns without end is joined the shorter way round: the same place a turn on is the same node.
class ArmRoadmap {
 public:
  using Node = std::size_t;

  /// A node that is joined to no other yet.
  Node add(kinematics::Configuration at);
  /// `turned`: the configuration of `to`, as many whole turns on as the straight way from `from` ends at.
  void join(Node from, Node to, const kinematics::Configuration& turned);

  std::size_t size() const { return nodes_.size(); }
  const kinematics::Configuration& at(Node node) const { return nodes_[node]; }
  bool are_connected(Node one, Node other) const { return root_of(one) == root_of(other); }
  bool is_reached(Node node) const { return are_connected(0, node); }

  /// From the start to a node over as few others as possible; each step is straight in joint space. The last
  /// may be whole turns off the node's own configuration. Empty: there is none.
  std::vector<kinematics::Configuration> way_to(Node node) const;

 private:
  struct Edge {
    Node to = 0;
    kinematics::Configuration change;
  };
  Node root_of(Node) const;

  std::vector<kinematics::Configuration> nodes_;
  std::vector<std::vector<Edge>> edges_;
  std::vector<Node> parents_;  ///< a forest: two nodes are connected when they have the same root
};

}  // namespace limpet::evaluation
