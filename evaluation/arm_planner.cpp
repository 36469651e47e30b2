// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <limits>
#include <limpet/evaluation/arm_planner_internal.hpp>
#include <utility>

namespace limpet::evaluation {
namespace {

using kinematics::Configuration;

constexpr std::size_t kNeighbours = 6;   // that a node is tried to be joined to
constexpr std::size_t kMostSkipped = 8;  // configurations of a known way between two that are kept
constexpr int kGrowths = 60;             // of a search tree
constexpr double kGrowth = 0.25;         // how far it grows at once, as a share of the way to its aim

}  // namespace

ArmPlanner::ArmPlanner(const ArmSpace& space, const Configuration& start, survey::Random& random)
    : space_(space), random_(random) {
  roadmap_.add(start);
}

bool ArmPlanner::try_join(Node from, Node to) {
  const Configuration turned = space_.near(roadmap_.at(from), roadmap_.at(to));
  if (!space_.joins(roadmap_.at(from), turned)) return false;
  roadmap_.join(from, to, turned);
  return true;
}

void ArmPlanner::add_way(std::span<const Configuration> way) {
  const std::size_t begin = known_.size();
  for (const Configuration& at : way)
    if (space_.holds(at)) known_.push_back({at, 0, 0, std::nullopt});
  Node last = 0;
  for (std::size_t next = begin; next < known_.size();) {
    std::size_t far = std::min(next + kMostSkipped, known_.size()) - 1;
    bool joined = space_.joins(roadmap_.at(last), known_[far].at);
    for (; !joined && far > next; joined = space_.joins(roadmap_.at(last), known_[far].at))
      far = next + (far - next) / 2;
    const Node node = roadmap_.add(known_[far].at);
    if (joined)
      roadmap_.join(last, node, known_[far].at);
    else
      connect(node, true);
    known_[far].node = node;
    for (; next <= far; ++next) known_[next].before = last, known_[next].after = node;
    last = node;
  }
}

ArmPlanner::Node ArmPlanner::node_of_known(std::size_t i) {
  Known& known = known_[i];
  if (known.node) return *known.node;
  const Node node = roadmap_.add(known.at);
  known.node = node;
  if (!try_join(node, known.before) && !try_join(node, known.after) && i > 0)
    try_join(node, node_of_known(i - 1));
  return node;
}

void ArmPlanner::add_random(int count) {
  for (int i = 0; i < count; ++i)
    if (const Configuration at = space_.random(random_); space_.holds(at)) add(at, {}, false);
}

std::vector<ArmPlanner::Node> ArmPlanner::nearest(const Configuration& at, std::size_t count,
                                                  bool reached) const {
  std::vector<std::pair<double, Node>> found;
  for (Node node = 0; node < roadmap_.size(); ++node)
    if (roadmap_.is_reached(node) == reached)
      found.emplace_back(space_.distance(at, roadmap_.at(node)), node);
  count = std::min(count, found.size());
  std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count), found.end());
  std::vector<Node> nodes;
  for (std::size_t i = 0; i < count; ++i) nodes.push_back(found[i].second);
  return nodes;
}

ArmPlanner::Node ArmPlanner::add(const Configuration& at, std::span<const Node> beside, bool search) {
  const Node node = roadmap_.add(at);
  for (const Node other : beside)
    if (try_join(node, other)) break;
  connect(node, search);
  return node;
}

void ArmPlanner::connect(Node node, bool search) {
  for (const bool reached : {true, false})
    for (const Node other : nearest(roadmap_.at(node), kNeighbours, reached))
      if (roadmap_.is_reached(other) != roadmap_.is_reached(node)) try_join(node, other);
  if (search && !roadmap_.is_reached(node)) grow_towards_roadmap(node);
}

/// Towards random configurations, some of the way, as far as that is clear; what has grown is tried to be
/// joined to what is reached and near it.
void ArmPlanner::grow_towards_roadmap(Node root) {
  std::vector<Node> tree{root};
  for (int i = 0; i < kGrowths && !roadmap_.is_reached(root); ++i) {
    const Configuration aim = space_.random(random_);
    Node from = root;
    double least = std::numeric_limits<double>::infinity();
    for (const Node node : tree)
      if (const double d = space_.distance(roadmap_.at(node), aim); d < least) least = d, from = node;
    const Configuration begin = roadmap_.at(from);
    Configuration to = space_.near(begin, aim);
    double share = kGrowth;
    const Configuration whole = to - begin;
    for (; share > kGrowth / 8; share /= 2)
      if (space_.joins(begin, to = begin + share * whole)) break;
    if (share <= kGrowth / 8) continue;
    const Node grown = roadmap_.add(to);
    roadmap_.join(from, grown, to);
    tree.push_back(grown);
    for (const Node other : nearest(to, 2, true))
      if (try_join(grown, other)) break;
  }
}

}  // namespace limpet::evaluation
