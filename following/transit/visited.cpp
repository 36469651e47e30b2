// Copyright the limpet authors. GPL-3.0-or-later.
#include "visited_internal.hpp"

#include <algorithm>
#include <limits>
#include <queue>

namespace limpet::following::internal {

using Eigen::Vector3d;

Visited::Link* Visited::find(std::size_t from, std::size_t to) {
  auto& links = nodes_[from].links;
  const auto link = std::find_if(links.begin(), links.end(), [&](const Link& l) { return l.to == to; });
  return link == links.end() ? nullptr : &*link;
}

void Visited::link(std::size_t a, std::size_t b) {
  if (a == b || find(a, b)) return;
  const double length = (nodes_[a].at - nodes_[b].at).norm();
  nodes_[a].links.push_back({b, length});
  nodes_[b].links.push_back({a, length});
}

void Visited::arrive(const model::View& view, const Clearance& clearance, const Vector3d& here) {
  std::vector<std::pair<double, std::size_t>> near;
  places_.for_each_within(here, near_, [&](const Vector3d& at, std::size_t node) {
    near.emplace_back((at - here).norm(), node);
  });
  std::sort(near.begin(), near.end());
  const std::size_t before = present_;
  if (!near.empty() && near.front().first < same_) {
    present_ = near.front().second;
  } else {
    present_ = nodes_.size();
    nodes_.push_back({here, {}});
    places_.put(here, present_);
  }
  link(before, present_);
  constexpr std::size_t kLinks = 6;
  for (std::size_t i = 0; i < std::min(near.size(), kLinks) && present_ + 1 == nodes_.size(); ++i)
    if (clearance.is_clear(view, here, nodes_[near[i].second].at)) link(present_, near[i].second);
}

void Visited::block(const Vector3d& to) {
  places_.for_each_within(to, 0, [&](const Vector3d&, std::size_t node) {
    for (Link& there : nodes_[node].links) {
      there.length += detour_;
      find(there.to, node)->length += detour_;
    }
  });
}

std::vector<Vector3d> Visited::way_to(const std::function<bool(const Vector3d&)>& wanted) const {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::vector<double> length(nodes_.size(), kFar);
  std::vector<std::size_t> before(nodes_.size(), nodes_.size());
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  if (nodes_.empty()) return {};
  length[present_] = 0;
  open.emplace(0, present_);
  while (!open.empty()) {
    const auto [so_far, node] = open.top();
    open.pop();
    if (so_far > length[node]) continue;
    if (node != present_ && wanted(nodes_[node].at)) {
      std::vector<Vector3d> way;
      for (std::size_t i = node; i != nodes_.size(); i = before[i]) way.push_back(nodes_[i].at);
      std::reverse(way.begin(), way.end());
      return way;
    }
    for (const Link& link : nodes_[node].links) {
      const double through = so_far + link.length;
      if (through >= length[link.to]) continue;
      length[link.to] = through;
      before[link.to] = node;
      open.emplace(through, link.to);
    }
  }
  return {};
}

}  // namespace limpet::following::internal
