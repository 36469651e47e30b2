// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/evaluation/arm_roadmap.hpp>
#include <limpet/evaluation/arm_space_internal.hpp>
#include <limpet/survey/random.hpp>
#include <optional>
#include <span>
#include <vector>

namespace limpet::evaluation {

/// Grows a roadmap of a robot's clear configurations.
class ArmPlanner {
 public:
  using Node = ArmRoadmap::Node;

  /// The space must outlive it. If the start is not clear nothing is joined to it.
  ArmPlanner(const ArmSpace&, const kinematics::Configuration& start, survey::Random&);

  const ArmRoadmap& roadmap() const { return roadmap_; }

  /// Adds configurations that are known to follow each other, thinned: between two that are kept the straight
  /// way is clear. What is not clear is left out; what is not joined to what is before by a clear way is left
  /// to be joined as others are.
  void add_way(std::span<const kinematics::Configuration>);

  /// The clear ones of all known configurations.
  std::size_t known_count() const { return known_.size(); }
  const kinematics::Configuration& known(std::size_t i) const { return known_[i].at; }
  /// The node of a known configuration, which is added if it was thinned out.
  Node node_of_known(std::size_t i);

  /// Adds random configurations that are clear, each joined to some that are near it.
  void add_random(int count);

  /// Adds a configuration that is clear, and joins it to `beside` if a straight way is; else to what is near
  /// it, and if `search`, by a small search tree (RRT-Connect: Kuffner, LaValle 2000) whose other tree is the
  /// roadmap. It may remain unconnected.
  Node add(const kinematics::Configuration&, std::span<const Node> beside, bool search);

  /// The nodes, reached or not, that are nearest to a configuration, at most `count`, the nearest first.
  std::vector<Node> nearest(const kinematics::Configuration&, std::size_t count, bool reached) const;

 private:
  /// A known configuration, and the kept nodes between which the way goes past it.
  struct Known {
    kinematics::Configuration at;
    Node before = 0, after = 0;
    std::optional<Node> node;
  };

  bool try_join(Node, Node);
  void connect(Node, bool search);
  void grow_towards_roadmap(Node);

  const ArmSpace& space_;
  survey::Random& random_;
  ArmRoadmap roadmap_;
  std::vector<Known> known_;
};

}  // namespace limpet::evaluation
