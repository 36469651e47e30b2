// Copyright the limpet authors. GPL-3.0-or-later.
#include "visited_internal.hpp"

#include <algorithm>

namespace limpet::following::internal {

using Eigen::Vector3d;

Visited::Link* Visited::find(std::size_t from, std::size_t to) {
  auto& links = links_[from];
  const auto link = std::find_if(links.begin(), links.end(), [&](const Link& l) { return l.to == to; });
  return link == links.end() ? nullptr : &*link;
}

void Visited::link(std::size_t a, std::size_t b) {
  if (a == b || find(a, b)) return;
  const double length = (nodes_[a] - nodes_[b]).norm();
  links_[a].push_back({b, length});
  links_[b].push_back({a, length});
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
    nodes_.push_back(here);
    links_.emplace_back();
    places_.put(here, present_);
  }
  link(before, present_);
  constexpr std::size_t kLinks = 6;
  for (std::size_t i = 0; i < std::min(near.size(), kLinks) && present_ + 1 == nodes_.size(); ++i)
    if (clearance.is_clear(view, here, nodes_[near[i].second])) link(present_, near[i].second);
}

void Visited::block(const Vector3d& to) {
  places_.for_each_within(to, 0, [&](const Vector3d&, std::size_t node) {
    for (Link& there : links_[node]) {
      there.length += detour_;
      find(there.to, node)->length += detour_;
    }
  });
}

std::vector<Vector3d> Visited::way_to(const std::function<bool(const Vector3d&)>& wanted) const {
  std::vector<Vector3d> way;
  for (const std::size_t node :
       cheapest_way(links_, present_, [&](std::size_t i) { return i != present_ && wanted(nodes_[i]); }))
    way.push_back(nodes_[node]);
  return way;
}

}  // namespace limpet::following::internal
