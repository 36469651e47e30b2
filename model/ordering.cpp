// Copyright the limpet authors. GPL-3.0-or-later.
//
// The orderings of shared edges on boundary cycles (thesis §2.2), and dissolving what breaks them (§2.4.3,
// §2.6).
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <unordered_map>

#include "common_line_internal.hpp"
#include "sharing_internal.hpp"

namespace limpet::model::internal {
namespace {

using geometry::CycleId;
using geometry::EdgeId;
using geometry::Slot;

/// The shared edges of a cycle in its direction, and for each the slot of the neighbour across it.
struct SharedCycle {
  std::vector<EdgeId> edges;
  std::vector<std::uint32_t> neighbours;
};

SharedCycle shared_on(const Complex& complex, const geometry::Polygon& perimeter,
                      const geometry::Polygon::Cycle& cycle) {
  SharedCycle result;
  Slot s = cycle.first;
  for (std::uint32_t i = 0; i < cycle.size; ++i, s = perimeter.next(s)) {
    const auto& node = perimeter.node(s);
    if (!node.shared) continue;
    result.edges.push_back(node.edge);
    result.neighbours.push_back(complex.edges().across(node.edge).segment);
  }
  return result;
}

/// Two neighbours whose edges alternate (a b a b), if any. Neighbours are kept on a stack; returning to one
/// closes those above it, and a further edge of a closed one is out of order.
std::optional<std::pair<std::uint32_t, std::uint32_t>> globally_disordered(const SharedCycle& cycle) {
  std::vector<std::uint32_t> open, closed, closed_by;
  for (const std::uint32_t n : cycle.neighbours) {
    if (const auto c = std::find(closed.begin(), closed.end(), n); c != closed.end())
      return std::pair(n, closed_by[static_cast<std::size_t>(c - closed.begin())]);
    const auto at = std::find(open.begin(), open.end(), n);
    if (at == open.end()) {
      open.push_back(n);
      continue;
    }
    for (; open.back() != n; open.pop_back()) closed.push_back(open.back()), closed_by.push_back(n);
  }
  return std::nullopt;
}

/// A neighbour, if there is one, on one of whose cycles the partners do not follow in descending cyclic
/// order.
std::optional<std::uint32_t> locally_disordered(const Complex& complex, const SharedCycle& cycle) {
  // The place of each partner on its own cycle, found by walking that cycle once.
  std::map<std::pair<std::uint32_t, CycleId>, std::vector<EdgeId>> partners;
  for (const EdgeId edge : cycle.edges) {
    const EdgePlace& other = complex.edges().across(edge);
    partners[{other.segment, complex.at(other.segment).polygon->perimeter.node(other.slot).cycle}].push_back(
        complex.edges().at(edge).partner);
  }
  for (const auto& [place, sequence] : partners) {
    if (sequence.size() < 3) continue;  // two are always in order
    const auto& perimeter = complex.at(place.first).polygon->perimeter;
    std::unordered_map<std::uint64_t, std::size_t> at;
    const SharedCycle theirs = shared_on(complex, perimeter, perimeter.cycle(place.second));
    for (std::size_t i = 0; i < theirs.edges.size(); ++i) at[theirs.edges[i].value] = i;
    std::size_t rises = 0;
    for (std::size_t k = 0; k < sequence.size(); ++k)
      rises += at[sequence[k].value] < at[sequence[(k + 1) % sequence.size()].value];
    if (rises > 1) return place.first;
  }
  return std::nullopt;
}

/// Dissolves two neighbours; they share no further edges until the next set (§2.6).
void dissolve_pair(Complex& complex, Agenda& agenda, const Segment& a, const Segment& b) {
  agenda.note_disorder(a.id, b.id);
  complex.dissolve_neighbours(a, b);
}

/// The first neighbours of s found to break an ordering on one of its cycles: one (local), or two that
/// alternate (global).
std::optional<std::pair<std::uint32_t, std::optional<std::uint32_t>>> first_disorder(const Complex& complex,
                                                                                     const Segment& s) {
  const auto& perimeter = s.polygon->perimeter;
  for (const auto& cycle : perimeter.cycles()) {
    if (cycle.size == 0) continue;
    const SharedCycle shared = shared_on(complex, perimeter, cycle);
    if (shared.edges.size() < 3) continue;
    if (const auto other = locally_disordered(complex, shared)) return std::pair(*other, std::nullopt);
    if (const auto both = globally_disordered(shared))
      return std::pair(both->first, std::optional(both->second));
  }
  return std::nullopt;
}

bool dissolve_first_disorder(Complex& complex, Agenda& agenda, const Segment& s) {
  const auto disorder = first_disorder(complex, s);
  if (!disorder) return false;
  dissolve_pair(complex, agenda, s, complex.at(disorder->first));
  if (disorder->second) dissolve_pair(complex, agenda, s, complex.at(*disorder->second));
  return true;
}

/// The next shared edge after `s` or before it, if it is within kMaxOrderSteps edges.
std::optional<EdgeId> shared_after(const geometry::Polygon& perimeter, Slot s, bool forward) {
  for (int i = 0; i < kMaxOrderSteps; ++i) {
    s = forward ? perimeter.next(s) : perimeter.prev(s);
    if (perimeter.node(s).shared) return perimeter.node(s).edge;
  }
  return std::nullopt;
}

}  // namespace

bool order_stays(const Complex& complex, EdgeId edge) {
  const EdgePlace &mine = complex.edges().at(edge), &other = complex.edges().across(edge);
  const Segment &a = complex.at(mine.segment), &b = complex.at(other.segment);
  if (complex.edges_between(a, b).size() == 1) return true;
  for (const bool forward : {true, false}) {
    const auto beside = shared_after(a.polygon->perimeter, mine.slot, forward);
    if (!beside || *beside == edge) continue;
    const auto beside_other = shared_after(b.polygon->perimeter, other.slot, !forward);
    if (beside_other && complex.edges().at(*beside).partner == *beside_other) return true;
  }
  return false;
}

bool is_disordered(const Complex& complex, const Segment& s) {
  return first_disorder(complex, s).has_value();
}

bool dissolve_disordered(Complex& complex, Agenda& agenda, const Segment& s) {
  bool any = false;
  while (!s.polygon->shared.empty() && dissolve_first_disorder(complex, agenda, s)) any = true;
  return any;
}

void keep_one_concavity(Complex& complex, const Segment& s, const std::vector<EdgeId>& edges) {
  const PolygonPart& part = *s.polygon;
  const EdgeTable& table = complex.edges();
  for (const std::uint32_t n : complex.neighbours_across(edges)) {
    const auto line = common_line(part.plane(), complex.at(n).polygon->plane(), part.box.center());
    if (!line) continue;
    std::array<double, 2> length{};  // of the concave edges, and of the convex ones
    std::array<std::vector<EdgeId>, 2> kinds;
    for (const EdgeId shared : complex.edges_between(s, complex.at(n))) {
      const EdgeId edge = s.slot < n ? shared : table.at(shared).partner;
      const Slot slot = table.at(edge).slot;
      const double along = line->along.dot(part.position(part.perimeter.next(slot)) - part.position(slot));
      length[along > 0] += std::abs(along);
      kinds[along > 0].push_back(edge);
    }
    if (kinds[0].empty() || kinds[1].empty()) continue;
    for (const EdgeId edge : kinds[length[0] > length[1]])
      if (table.shared(edge)) complex.unshare(edge);
  }
}

}  // namespace limpet::model::internal
