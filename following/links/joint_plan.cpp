// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/following/links/goal_postures.hpp>
#include <limpet/following/links/halton_internal.hpp>
#include <limpet/following/links/joint_plan.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace limpet::following {
namespace {

using kinematics::Configuration;
using kinematics::Posture;

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

struct Tree {
  struct Node {
    Configuration at;
    std::size_t parent = kNone;
    std::size_t root = 0;  ///< of a tree from the roadmap: the node there
  };
  std::vector<Node> nodes;

  std::size_t nearest(const Configuration& to, const Roadmap& roadmap) const {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (const double steps = roadmap.steps(nodes[i].at, to); steps < least) best = i, least = steps;
    return best;
  }
  std::size_t add(const Configuration& at, std::size_t parent) {
    nodes.push_back({at, parent, nodes[parent].root});
    return nodes.size() - 1;
  }
  /// From a node to its root.
  std::vector<Configuration> way_back(std::size_t node) const {
    std::vector<Configuration> way;
    for (std::size_t i = node; i != kNone; i = nodes[i].parent) way.push_back(nodes[i].at);
    return way;
  }
};

class Planner {
 public:
  Planner(const LinkMotion& links, const Roadmap& roadmap, bool only_sensed)
      : links_(links), roadmap_(roadmap), only_sensed_(only_sensed) {}

  std::optional<JointPlan> plan(const std::vector<std::size_t>& roots, const Configuration& goal) {
    constexpr int kSamples = 150;
    Tree from, to;
    for (const std::size_t node : roots) from.nodes.push_back({roadmap_.nodes()[node].at, kNone, node});
    to.nodes.push_back({goal, kNone, 0});
    if (only_sensed_ && !is_allowed(goal)) return std::nullopt;
    if (const std::size_t met = grow(from, goal); is_at(from, met, goal)) return joined(from, met, to, 0);
    Tree *grown = &from, *other = &to;
    for (int i = 1; i <= kSamples; ++i, std::swap(grown, other)) {
      const std::size_t fresh = grow_a_piece(*grown, sample(i, grown->nodes.front().at));
      if (fresh == kNone) continue;
      const Configuration at = grown->nodes[fresh].at;
      const std::size_t met = grow(*other, at);
      if (!is_at(*other, met, at)) continue;
      return grown == &from ? joined(from, fresh, to, met) : joined(from, met, to, fresh);
    }
    return std::nullopt;
  }

 private:
  static constexpr double kPiece = 0.4;  // rad, or lengths

  Configuration sample(int i, const Configuration& about) const {
    constexpr double kAbout = 0.6;
    const Eigen::VectorXd unit = internal::halton(i, about.size());
    if (i % 4 < 2) return spread_over(links_.guard().robot(), unit);
    return about + kAbout * (unit.array() * 2 - 1).matrix();
  }

  static bool is_at(const Tree& tree, std::size_t node, const Configuration& at) {
    return node != kNone && tree.nodes[node].at == at;
  }

  bool is_allowed(const Configuration& at) const {
    return !only_sensed_ || links_.is_sensed(Posture(links_.guard().robot(), at));
  }

  bool connects(const Configuration& a, const Configuration& b) const {
    return is_allowed(b) && is_allowed((a + b) / 2) && links_.guard().connects(a, b, links_.obstacles());
  }

  /// A piece of the way from the nearest node to a sample; kNone: it is not clear.
  std::size_t grow_a_piece(Tree& tree, const Configuration& to) const {
    const std::size_t nearest = tree.nearest(to, roadmap_);
    const Configuration from = tree.nodes[nearest].at, way = to - from;
    const Configuration next = way.norm() > kPiece ? Configuration(from + way * (kPiece / way.norm())) : to;
    if (!connects(from, next)) return kNone;
    return tree.add(next, nearest);
  }

  /// Piece by piece as far as it is clear; the last node, or kNone when there is none.
  std::size_t grow(Tree& tree, const Configuration& to) const {
    std::size_t last = kNone;
    for (;;) {
      const std::size_t next = grow_a_piece(tree, to);
      if (next == kNone) return last;
      last = next;
      if (tree.nodes[next].at == to) return last;
    }
  }

  JointPlan joined(const Tree& from, std::size_t a, const Tree& to, std::size_t b) const {
    std::vector<Configuration> way = from.way_back(a);
    std::reverse(way.begin(), way.end());
    const std::vector<Configuration> rest = to.way_back(b);
    way.insert(way.end(), rest.begin() + 1, rest.end());
    const std::size_t root = from.nodes[a].root;
    way = shortened(std::move(way));
    return {root, {way.begin() + 1, way.end()}};
  }

  /// Without what can be left out.
  std::vector<Configuration> shortened(std::vector<Configuration> way) const {
    for (std::size_t i = 0; i + 2 < way.size(); ++i)
      for (std::size_t j = way.size() - 1; j > i + 1; --j)
        if (connects_far(way[i], way[j])) {
          way.erase(way.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                    way.begin() + static_cast<std::ptrdiff_t>(j));
          break;
        }
    return way;
  }

  bool connects_far(const Configuration& a, const Configuration& b) const {
    const Configuration way = b - a;
    const int pieces = 1 + static_cast<int>(way.norm() / kPiece);
    for (int i = 1; i <= pieces; ++i)
      if (!is_allowed(a + way * (static_cast<double>(i) / pieces))) return false;
    return links_.guard().connects(a, b, links_.obstacles());
  }

  const LinkMotion& links_;
  const Roadmap& roadmap_;
  bool only_sensed_;
};

}  // namespace

std::optional<JointPlan> plan_to(const std::vector<Configuration>& goals, const LinkMotion& links,
                                 const Roadmap& roadmap) {
  return plan_to_but_from(kNone, goals, links, roadmap);
}

std::optional<JointPlan> plan_to_but_from(std::size_t node, const std::vector<Configuration>& goals,
                                          const LinkMotion& links, const Roadmap& roadmap) {
  constexpr std::size_t kRoots = 40;
  for (const bool only_sensed : {true, false})
    for (const Configuration& goal : goals) {
      std::vector<std::size_t> roots = roadmap.nearest(goal, kRoots);
      std::erase(roots, node);
      if (roots.empty()) continue;
      if (auto plan = Planner(links, roadmap, only_sensed).plan(roots, goal)) return plan;
    }
  return std::nullopt;
}

std::optional<JointPlan> plan_from(std::size_t node, const std::vector<Configuration>& goals,
                                   const LinkMotion& links, const Roadmap& roadmap) {
  for (const bool only_sensed : {true, false})
    for (const Configuration& goal : goals)
      if (auto plan = Planner(links, roadmap, only_sensed).plan({node}, goal)) return plan;
  return std::nullopt;
}

}  // namespace limpet::following
