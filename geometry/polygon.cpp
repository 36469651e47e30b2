// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <limpet/geometry/polygon.hpp>

#include <limpet/geometry/judge.hpp>
#include <limpet/geometry/predicates.hpp>

namespace limpet::geometry {

std::optional<Polygon> Polygon::from_cycles(std::span<const std::vector<NewVertex>> cycles, EdgeIds& ids) {
  if (judge_cycles(cycles) != Verdict::valid) return std::nullopt;
  Polygon polygon;
  for (const auto& vertices : cycles) {
    const CycleId id = polygon.add_cycle();
    Slot last = kNoSlot;
    for (const NewVertex& v : vertices) {
      const Slot s = polygon.add_node(v, id, ids);
      Cycle& cycle = polygon.cycles_[static_cast<std::uint32_t>(id)];
      if (last == kNoSlot) {
        cycle.first = s;
      } else {
        polygon.nodes_[static_cast<std::uint32_t>(last)].next = s;
        polygon.nodes_[static_cast<std::uint32_t>(s)].prev = last;
      }
      ++cycle.size;
      last = s;
    }
    Cycle& cycle = polygon.cycles_[static_cast<std::uint32_t>(id)];
    cycle.hole = static_cast<std::uint32_t>(id) != 0;
    polygon.nodes_[static_cast<std::uint32_t>(last)].next = cycle.first;
    polygon.nodes_[static_cast<std::uint32_t>(cycle.first)].prev = last;
  }
  const Point2 o = polygon.origin_ = polygon.nodes_.front().at;
  for (const Node& n : polygon.nodes_) polygon.twice_area_ += cross(n.at - o, polygon.at(n.next) - o);
  polygon.rebuild_index();
  return polygon;
}

std::size_t Polygon::hole_count() const {
  return static_cast<std::size_t>(
      std::count_if(cycles_.begin(), cycles_.end(), [](const Cycle& c) { return c.size > 0 && c.hole; }));
}

std::vector<NewVertex> Polygon::vertices(const Cycle& cycle) const {
  std::vector<NewVertex> result;
  result.reserve(cycle.size);
  Slot s = cycle.first;
  for (std::uint32_t i = 0; i < cycle.size; ++i, s = next(s))
    result.push_back({at(s), node(s).edge, node(s).shared});
  return result;
}

const Polygon::Cycle& Polygon::outer() const {
  return *std::find_if(cycles_.begin(), cycles_.end(), [](const Cycle& c) { return c.size > 0 && !c.hole; });
}

std::vector<std::vector<NewVertex>> Polygon::boundary() const {
  std::vector<std::vector<NewVertex>> result;
  for (const bool holes : {false, true})
    for (const Cycle& c : cycles_)
      if (c.size > 0 && c.hole == holes) result.push_back(vertices(c));
  return result;
}

Polygon::Side Polygon::locate(Point2 p) const {
  if (!box_.contains(p)) return Side::outside;
  const auto on_edge = [&](Point2 a, Point2 b) {
    return box_of(a, b).contains(p) && orientation(a, b, p) == 0;
  };
  bool inside = false;
  if (!index_.active()) {
    for (const Node& n : nodes_) {
      if (!n.edge) continue;
      const Point2 a = n.at, b = at(n.next);
      if (std::max(a.x, b.x) < p.x || std::min(a.y, b.y) > p.y || std::max(a.y, b.y) < p.y) continue;
      if (on_edge(a, b)) return Side::boundary;
      if ((a.y <= p.y) != (b.y <= p.y))
        inside ^= a.y < b.y ? orientation(a, b, p) > 0 : orientation(b, a, p) > 0;
    }
    return inside ? Side::inside : Side::outside;
  }
  const auto side = index_.inside(p, [&](std::uint32_t i) {
    return Segment2{nodes_[i].at, at(nodes_[i].next)};
  });
  return !side ? Side::boundary : *side ? Side::inside : Side::outside;
}

Slot Polygon::add_node(const NewVertex& v, CycleId cycle, EdgeIds& ids) {
  std::uint32_t i = 0;
  if (free_.empty()) {
    i = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
  } else {
    i = free_.back();
    free_.pop_back();
  }
  const bool fresh = !v.edge;
  nodes_[i] = Node{v.at, kNoSlot, kNoSlot, cycle, fresh ? ids.take() : v.edge, v.shared};
  ++edge_count_;
  box_.add(v.at);
  created_.emplace_back(Slot{i}, nodes_[i].edge);
  return Slot{i};
}

void Polygon::free_node(Slot s) {
  nodes_[static_cast<std::uint32_t>(s)].edge = {};
  free_.push_back(static_cast<std::uint32_t>(s));
  --edge_count_;
}

CycleId Polygon::add_cycle() {
  for (std::uint32_t i = 0; i < cycles_.size(); ++i)
    if (cycles_[i].size == 0) return CycleId{i};
  cycles_.emplace_back();
  return CycleId{static_cast<std::uint32_t>(cycles_.size() - 1)};
}

void Polygon::relabel(Slot first, CycleId id, bool hole) {
  Cycle cycle{first, 0, hole};
  Slot s = first;
  do {
    nodes_[static_cast<std::uint32_t>(s)].cycle = id;
    ++cycle.size;
    s = next(s);
  } while (s != first);
  cycles_[static_cast<std::uint32_t>(id)] = cycle;
}

void Polygon::rebuild_index() {
  box_ = {};
  for (const Node& n : nodes_)
    if (n.edge) box_.add(n.at);
  index_.clear();
  if (index_size() < EdgeIndex::kMinimum) return;
  index_.reset(box_, index_size());
  fill_index();
}

void Polygon::fill_index() {
  std::vector<Segment2> all;
  all.reserve(edge_count_);
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
    if (!nodes_[i].edge) continue;
    const Point2 a = nodes_[i].at, b = at(nodes_[i].next);
    index_.add(i, a, b);
    all.emplace_back(a, b);
  }
  index_.flip(all);
}

std::vector<EdgeId> Polygon::take_removed() { return std::exchange(removed_, {}); }
std::vector<std::pair<Slot, EdgeId>> Polygon::take_created() { return std::exchange(created_, {}); }
void Polygon::take_changes(std::vector<EdgeId>& removed, std::vector<std::pair<Slot, EdgeId>>& created) {
  removed.swap(removed_), created.swap(created_);
  removed_.clear(), created_.clear();
}

}  // namespace limpet::geometry
