// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <limpet/evaluation/arm_roadmap.hpp>
#include <utility>

namespace limpet::evaluation {

using kinematics::Configuration;

ArmRoadmap::Node ArmRoadmap::add(Configuration at) {
  nodes_.push_back(std::move(at));
  edges_.emplace_back();
  parents_.push_back(nodes_.size() - 1);
  return nodes_.size() - 1;
}

void ArmRoadmap::join(Node from, Node to, const Configuration& turned) {
  const Configuration change = turned - nodes_[from];
  edges_[from].push_back({to, change});
  edges_[to].push_back({from, -change});
  const Node one = root_of(from), other = root_of(to), low = std::min(one, other),
             high = std::max(one, other);
  for (Node node = to; parents_[node] != node;) node = std::exchange(parents_[node], low);  // shorter chains
  parents_[high] = low;
}

ArmRoadmap::Node ArmRoadmap::root_of(Node node) const {
  while (parents_[node] != node) node = parents_[node];
  return node;
}

std::vector<Configuration> ArmRoadmap::way_to(Node node) const {
  if (!is_reached(node)) return {};
  std::vector<const Edge*> came(nodes_.size(), nullptr);
  std::vector<Node> from(nodes_.size(), 0), open{0};
  for (std::size_t next = 0; open[next] != node; ++next)
    for (const Edge& edge : edges_[open[next]]) {
      if (edge.to == 0 || came[edge.to] != nullptr) continue;
      came[edge.to] = &edge;
      from[edge.to] = open[next];
      open.push_back(edge.to);
    }
  std::vector<const Edge*> steps;
  for (Node at = node; at != 0; at = from[at]) steps.push_back(came[at]);
  std::vector<Configuration> way{nodes_.front()};
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) way.push_back(way.back() + (*step)->change);
  return way;
}

}  // namespace limpet::evaluation
