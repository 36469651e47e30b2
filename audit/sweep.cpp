// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <iterator>
#include <limpet/audit/sweep.hpp>
#include <set>

namespace limpet::audit {
namespace {

// Shamos and Hoey's plane sweep over the vertices in the order of Points (by x, then y), which stops at the
// first clash it finds.
//
// Why it misses none. All vertices are distinct (checked first). Let p be the first point, in sweep order,
// where a forbidden pair meets. Until p the active edges, those the sweep line crosses, are strictly ordered,
// and the active edges through p are adjacent in that order.
//  - If an edge ends at p, or p is no vertex, then two edges through p were adjacent before p, and were
//    tested when they became so.
//  - If p is a vertex where both of its edges begin, they are inserted there. The comparison with an active
//    edge through p, or of the two with each other when they overlap, finds them equal, which is reported as
//    a clash.
struct SweepEdge {
  Point left, right;
  EdgePlace place;
  std::size_t cycle_size = 0;
};

bool are_consecutive(const SweepEdge& e, const SweepEdge& f) {
  if (e.place.cycle != f.place.cycle) return false;
  const std::size_t n = e.cycle_size;
  return (e.place.vertex + 1) % n == f.place.vertex || (f.place.vertex + 1) % n == e.place.vertex;
}

bool is_forbidden(const SweepEdge& e, const SweepEdge& f) {
  const Meeting how = meeting({e.left, e.right}, {f.left, f.right});
  return are_consecutive(e, f) ? how == Meeting::kOverlap : how != Meeting::kNone;
}

struct IsBelow {
  bool operator()(const SweepEdge* e, const SweepEdge* f) const {
    if (e == f) return false;
    if (e->left == f->left) return orientation(e->left, e->right, f->right) > 0;
    if (e->left < f->left) return orientation(e->left, e->right, f->left) > 0;
    return orientation(f->left, f->right, e->left) < 0;
  }
};

class Sweep {
 public:
  explicit Sweep(const std::vector<std::vector<Point>>& cycles) : cycles_(cycles) {
    for (std::size_t c = 0; c < cycles.size(); ++c) {
      first_edge_.push_back(edges_.size());
      const std::size_t n = cycles[c].size();
      for (std::size_t i = 0; i < n; ++i) {
        const auto [left, right] = std::minmax(cycles[c][i], cycles[c][(i + 1) % n]);
        edges_.push_back({left, right, {c, i}, n});
        vertices_.push_back({c, i});
      }
    }
    std::sort(vertices_.begin(), vertices_.end(),
              [this](const EdgePlace& a, const EdgePlace& b) { return at(a) < at(b); });
  }

  std::optional<Clash> run() {
    for (std::size_t i = 1; i < vertices_.size(); ++i)
      if (at(vertices_[i - 1]) == at(vertices_[i])) return Clash{vertices_[i - 1], vertices_[i]};
    where_.resize(edges_.size(), active_.end());
    for (const EdgePlace& vertex : vertices_)
      if (auto clash = pass(vertex)) return clash;
    return {};
  }

 private:
  const Point& at(const EdgePlace& place) const { return cycles_[place.cycle][place.vertex]; }

  std::optional<Clash> pass(const EdgePlace& vertex) {
    const std::size_t n = cycles_[vertex.cycle].size();
    const std::size_t base = first_edge_[vertex.cycle];
    const std::size_t here[] = {base + (vertex.vertex + n - 1) % n, base + vertex.vertex};
    for (const std::size_t e : here)
      if (edges_[e].right == at(vertex))
        if (auto clash = remove(e)) return clash;
    for (const std::size_t e : here)
      if (edges_[e].left == at(vertex))
        if (auto clash = insert(e)) return clash;
    return {};
  }

  std::optional<Clash> insert(std::size_t e) {
    const auto [place, inserted] = active_.insert(&edges_[e]);
    if (!inserted) return Clash{(*place)->place, edges_[e].place};
    where_[e] = place;
    if (place != active_.begin() && is_forbidden(**std::prev(place), edges_[e]))
      return Clash{(*std::prev(place))->place, edges_[e].place};
    const auto above = std::next(place);
    if (above != active_.end() && is_forbidden(**above, edges_[e]))
      return Clash{(*above)->place, edges_[e].place};
    return {};
  }

  std::optional<Clash> remove(std::size_t e) {
    const auto above = active_.erase(where_[e]);
    if (above == active_.end() || above == active_.begin()) return {};
    const auto below = std::prev(above);
    if (is_forbidden(**below, **above)) return Clash{(*below)->place, (*above)->place};
    return {};
  }

  using Active = std::set<const SweepEdge*, IsBelow>;

  const std::vector<std::vector<Point>>& cycles_;
  std::vector<SweepEdge> edges_;
  std::vector<std::size_t> first_edge_;  // by cycle
  std::vector<EdgePlace> vertices_;      // in sweep order
  Active active_;                        // edges that cross the sweep line, from below
  std::vector<Active::iterator> where_;  // by edge
};

}  // namespace

std::optional<Clash> find_clash(const std::vector<std::vector<Point>>& cycles) { return Sweep(cycles).run(); }

}  // namespace limpet::audit
