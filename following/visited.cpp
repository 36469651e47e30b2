// Copyright the limpet authors. GPL-3.0-or-later.
#include "visited_internal.hpp"

#include <algorithm>
#include <limits>
#include <queue>

namespace limpet::following::internal {

using Eigen::Vector3d;

void Visited::link(std::size_t a, std::size_t b) {
  auto& next = nodes_[a].next;
  if (a == b || std::find(next.begin(), next.end(), b) != next.end()) return;
  next.push_back(b);
  nodes_[b].next.push_back(a);
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
  for (const std::size_t node : std::vector<std::size_t>(nodes_[present_].next))
    if (nodes_[node].at == to) {
      std::erase(nodes_[present_].next, node);
      std::erase(nodes_[node].next, present_);
    }
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
    for (const std::size_t next : nodes_[node].next) {
      const double through = so_far + (nodes_[next].at - nodes_[node].at).norm();
      if (through >= length[next]) continue;
      length[next] = through;
      before[next] = node;
      open.emplace(through, next);
    }
  }
  return {};
}

}  // namespace limpet::following::internal
