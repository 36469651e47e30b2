// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/following/links/roadmap.hpp>

#include <algorithm>

namespace limpet::following {

using kinematics::Configuration;
using kinematics::Posture;

double Roadmap::steps(const Configuration& a, const Configuration& b) const {
  const kinematics::LengthsByKind apart = kinematics::lengths_by_kind(guard_.robot(), a - b);
  const kinematics::Ceilings& ceilings = guard_.robot().ceilings;
  return std::max(apart.prismatic / ceilings.prismatic, apart.revolute_rad / ceilings.revolute_rad);
}

std::vector<std::size_t> Roadmap::nearest(const Configuration& at, std::size_t most) const {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < nodes_.size(); ++i) order.emplace_back(steps(nodes_[i].at, at), i);
  const std::size_t count = std::min(most, order.size());
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end());
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < count; ++i) result.push_back(order[i].second);
  return result;
}

Roadmap::Link* Roadmap::find(std::size_t from, std::size_t to) {
  const auto link =
      std::find_if(links_[from].begin(), links_[from].end(), [&](const Link& l) { return l.to == to; });
  return link == links_[from].end() ? nullptr : &*link;
}

void Roadmap::link(std::size_t a, std::size_t b) {
  if (a == b || find(a, b)) return;
  const double length = steps(nodes_[a].at, nodes_[b].at);
  links_[a].push_back({b, length});
  links_[b].push_back({a, length});
}

std::size_t Roadmap::add(const Configuration& at) {
  nodes_.push_back({at, Posture(guard_.robot(), at).control_point()});
  links_.emplace_back();
  return nodes_.size() - 1;
}

void Roadmap::arrive(const Posture& posture, const Obstacles& obstacles) {
  constexpr double kSame = 0.5, kNear = 4;  // steps
  constexpr std::size_t kLooked = 3;
  const Configuration& here = posture.configuration();
  const std::vector<std::size_t> near = nearest(here, kLooked);
  if (nodes_.empty()) {
    present_ = add(here);
    return;
  }
  const std::size_t before = present_;
  if (steps(nodes_[near.front()].at, here) < kSame) {
    present_ = near.front();
    link(before, present_);
    return;
  }
  present_ = add(here);
  link(before, present_);
  for (const std::size_t other : near)
    if (other != before && steps(nodes_[other].at, here) < kNear &&
        guard_.connects(here, nodes_[other].at, obstacles))
      link(present_, other);
}

void Roadmap::arrive_exactly(const Posture& posture) {
  if (!nodes_.empty() && nodes_[present_].at == posture.configuration()) return;
  const std::size_t before = present_;
  present_ = add(posture.configuration());
  link(before, present_);
}

std::size_t Roadmap::add_way(std::size_t from, const std::vector<Configuration>& way) {
  for (const Configuration& at : way) {
    const auto same =
        std::find_if(nodes_.begin(), nodes_.end(), [&](const Node& node) { return node.at == at; });
    const std::size_t next = same == nodes_.end() ? add(at) : static_cast<std::size_t>(same - nodes_.begin());
    link(from, next);
    from = next;
  }
  return from;
}

void Roadmap::block(std::size_t node) {
  constexpr double kDearer = 20;  // steps
  for (Link& there : links_[node]) {
    there.length += kDearer;
    find(there.to, node)->length += kDearer;
  }
}

std::vector<std::size_t> Roadmap::way_to(const std::function<bool(std::size_t)>& wanted) const {
  return cheapest_way(links_, present_, wanted);
}

}  // namespace limpet::following
