// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/evaluation/free_space.hpp>

#include <algorithm>
#include <cmath>
#include <limpet/evaluation/lattice_internal.hpp>
#include <map>
#include <optional>
#include <queue>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace limpet::evaluation {
namespace {

using Eigen::Vector3d;
using Node = Lattice::Node;
using MayStep = std::function<bool(const Node&, const Node&)>;

/// Spreads a flag from the nodes that have it, over steps that may be taken.
void flood(Lattice& lattice, std::vector<Node> open, Lattice::Flags flag, const MayStep& may_step) {
  while (!open.empty()) {
    const Node node = open.back();
    open.pop_back();
    lattice.leave(node, [&](const Node& from, const Node& to) {
      if ((lattice.flags(to) & flag) != 0 || !may_step(from, to)) return;
      lattice.mark(to, flag);
      open.push_back(to);
    });
  }
}

/// The nodes at most `count` away from a place's own along each axis.
std::vector<Node> nodes_around(const Lattice& lattice, const Vector3d& place, int count) {
  std::vector<Node> nodes;
  const Node middle = lattice.nearest(place);
  for (int z = -count; z <= count; ++z)
    for (int y = -count; y <= count; ++y)
      for (int x = -count; x <= count; ++x)
        if (const Node node = middle + Node(x, y, z); lattice.contains(node)) nodes.push_back(node);
  return nodes;
}

Vector3d clamped(const Vector3d& place, const Vector3d& low, const Vector3d& high) {
  return place.cwiseMax(low).cwiseMin(high);
}

FreeSpaceOptions checked(FreeSpaceOptions options, const simulation::Bounds& bounds) {
  if (!(options.clearance > 0)) throw std::invalid_argument("the clearance must be positive");
  if (!(options.margin >= 0)) throw std::invalid_argument("the margin must not be negative");
  if (options.pitch == 0) options.pitch = options.clearance / 2;
  // Coarser, and a step between cells that may be free could go through a wall.
  if (!(options.pitch > 0 && options.pitch <= 0.7 * options.clearance))
    throw std::invalid_argument("the pitch of free space must be at most 0.7 of the clearance");
  options.margin = std::max(options.margin, options.clearance) + 2 * options.pitch;
  const Vector3d size = (bounds.high - bounds.low).array() + 2 * options.margin;
  if ((size / (8 * options.pitch)).prod() > 5e7)
    throw std::invalid_argument("the pitch of free space is too small for a mesh of this size");
  return options;
}

}  // namespace

struct FreeSpace::Inside {
  Inside(const TrueSurface& surface, const simulation::Bounds& bounds, const FreeSpaceOptions& wanted)
      : truth(surface),
        options(checked(wanted, bounds)),
        lattice(truth, bounds.low.array() - options.margin, bounds.high.array() + options.margin,
                options.clearance, options.pitch) {
    const Vector3d low = bounds.low.array() - options.margin, high = bounds.high.array() + options.margin;
    // Outside the box nothing is in the way.
    const Vector3d start = clamped(options.start, low, high);
    flood(lattice, seeds(start, Lattice::kPassable, Lattice::kReached), Lattice::kReached,
          [this](const Node& from, const Node& to) { return is_clear(from, to); });
    flood(lattice, seeds(start, Lattice::kPossible, Lattice::kPerhapsReached), Lattice::kPerhapsReached,
          [this](const Node&, const Node& to) { return has(to, Lattice::kPossible); });
  }

  bool has(const Node& node, Lattice::Flags flag) const { return (lattice.flags(node) & flag) != 0; }

  bool is_clear(const Node& from, const Node& to) const {
    if (!has(from, Lattice::kPassable) || !has(to, Lattice::kPassable)) return false;
    if (has(from, Lattice::kRoomy) && has(to, Lattice::kRoomy)) return true;
    return truth.keeps(lattice.place(from), lattice.place(to), options.clearance);
  }

  /// The nodes around the start that it gets to, marked.
  std::vector<Node> seeds(const Vector3d& start, Lattice::Flags needed, Lattice::Flags reached) {
    const double least = std::min(options.clearance, truth.distance(start));
    std::vector<Node> found;
    for (const Node& node : nodes_around(lattice, start, 3)) {
      if (!has(node, needed)) continue;
      const double along = truth.distance_along(start, lattice.place(node));
      if (!(along > 0) || (needed == Lattice::kPassable && along < least)) continue;
      lattice.mark(node, reached);
      found.push_back(node);
    }
    return found;
  }

  /// A reached node beside a place that the straight way to keeps the clearance.
  std::optional<Node> joined(const Vector3d& place) const {
    const auto joins = [&](const Node& node) {
      return has(node, Lattice::kReached) && truth.keeps(place, lattice.place(node), options.clearance);
    };
    if (Node own = lattice.nearest(place); joins(own)) return own;
    for (const Node& node : nodes_around(lattice, place, 1))
      if (joins(node)) return node;
    return std::nullopt;
  }

  std::vector<Node> search(const Node& from, const Node& to) const;
  std::vector<Vector3d> shortened(const std::vector<Vector3d>& way) const;

  const TrueSurface& truth;
  FreeSpaceOptions options;
  Lattice lattice;
};

/// A* over the lattice's edges.
std::vector<Node> FreeSpace::Inside::search(const Node& from, const Node& to) const {
  struct Step {
    int length;
    Node before;
  };
  using Entry = std::tuple<int, int, std::int64_t, int, int, int>;  // bound, −length, index, node
  std::map<std::int64_t, Step> best{{lattice.index(from), {0, from}}};
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto push = [&](const Node& node, int length) {
    const int bound = length + (node - to).cwiseAbs().sum();
    open.emplace(bound, -length, lattice.index(node), node.x(), node.y(), node.z());
  };
  push(from, 0);
  while (!open.empty()) {
    const auto [bound, minus_length, index, x, y, z] = open.top();
    open.pop();
    const Node node(x, y, z);
    if (best.at(index).length != -minus_length) continue;
    if (node == to) break;
    for (int k = 0; k < 6; ++k) {
      Node next = node;
      next[k / 2] += 2 * (k % 2) - 1;
      if (!lattice.contains(next) || !is_clear(node, next)) continue;
      const auto [place, is_new] = best.try_emplace(lattice.index(next), Step{1 - minus_length, node});
      if (!is_new && place->second.length <= 1 - minus_length) continue;
      place->second = {1 - minus_length, node};
      push(next, 1 - minus_length);
    }
  }
  std::vector<Node> nodes;
  if (best.count(lattice.index(to)) == 0) return nodes;
  for (Node node = to; node != from; node = best.at(lattice.index(node)).before) nodes.push_back(node);
  nodes.push_back(from);
  std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

/// Leaves out what a straight way that keeps the clearance passes by: from each place on to the farthest it
/// sees, found by doubling and halving.
std::vector<Vector3d> FreeSpace::Inside::shortened(const std::vector<Vector3d>& way) const {
  std::vector<Vector3d> result{way.front()};
  for (std::size_t at = 0; at + 1 < way.size();) {
    std::size_t next = at + 1;
    for (std::size_t step = way.size(); step > 0; step /= 2)
      if (next + step < way.size() && truth.keeps(way[at], way[next + step], options.clearance)) next += step;
    result.push_back(way[next]);
    at = next;
  }
  return result;
}

FreeSpace::FreeSpace(const TrueSurface& truth, const simulation::Bounds& bounds,
                     const FreeSpaceOptions& options)
    : inside_(std::make_unique<Inside>(truth, bounds, options)) {}
FreeSpace::~FreeSpace() = default;
FreeSpace::FreeSpace(FreeSpace&&) noexcept = default;
FreeSpace& FreeSpace::operator=(FreeSpace&&) noexcept = default;

double FreeSpace::clearance() const { return inside_->options.clearance; }
double FreeSpace::pitch() const { return inside_->options.pitch; }

Verdict FreeSpace::holds(const Vector3d& place) const {
  return inside_->truth.distance(place) >= clearance() ? connects(place) : Verdict::no;
}

double FreeSpace::ruled_out(const Vector3d& place, const Vector3d& direction) const {
  const Node node = inside_->lattice.nearest(place);
  if (inside_->has(node, Lattice::kPerhapsReached)) return 0;
  const double half = pitch() / 2;
  const Vector3d from_middle = place - inside_->lattice.place(node);
  double leaves = pitch();
  for (int i = 0; i < 3; ++i)
    if (direction[i] != 0)
      leaves = std::min(leaves, (std::copysign(half, direction[i]) - from_middle[i]) / direction[i]);
  return std::max(leaves, 0.0) + 1e-6 * pitch();
}

Verdict FreeSpace::connects(const Vector3d& place) const {
  if (!inside_->has(inside_->lattice.nearest(place), Lattice::kPerhapsReached)) return Verdict::no;
  return inside_->joined(place) ? Verdict::yes : Verdict::doubtful;
}

std::vector<Vector3d> FreeSpace::way(const Vector3d& from, const Vector3d& to) const {
  if (inside_->truth.keeps(from, to, clearance())) return {from, to};
  const auto first = inside_->joined(from), last = inside_->joined(to);
  if (!first || !last) return {};
  std::vector<Vector3d> places{from};
  for (const Node& node : inside_->search(*first, *last)) places.push_back(inside_->lattice.place(node));
  if (places.size() == 1) return {};
  places.push_back(to);
  return inside_->shortened(places);
}

std::vector<Vector3d> FreeSpace::places_at(double distance) const {
  std::vector<Vector3d> places;
  const double reach = pitch() / 2;
  inside_->lattice.for_each(inside_->truth, Lattice::kReached, distance + reach, [&](const Node& node) {
    const Vector3d place = inside_->lattice.place(node);
    if (std::abs(inside_->truth.distance(place) - distance) <= reach) places.push_back(place);
  });
  return places;
}

double length_of(const std::vector<Vector3d>& way) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < way.size(); ++i) length += (way[i + 1] - way[i]).norm();
  return length;
}

}  // namespace limpet::evaluation
