// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/geometry/unite.hpp>

#include <array>
#include <cmath>
#include <tuple>

#include <limpet/geometry/fissure.hpp>
#include <limpet/geometry/judge.hpp>
#include <limpet/geometry/predicates.hpp>

#include "outline_internal.hpp"

namespace limpet::geometry {
namespace {

using internal::Outline;
using internal::OutlinePiece;
using internal::SourceEdge;

/// By how many grid steps b's vertices are moved outwards, one value for each attempt. 32 steps are λ/128 to
/// λ/64.
constexpr std::array kMoves = {0, 2, 6, 16, 32};

int reach_of(std::size_t attempt, double gap) {
  return std::min(kMoves[attempt], std::max(2, static_cast<int>(gap / 64)));
}

/// A pseudo-random whole number from -reach to reach that depends only on the vertex, the attempt and the
/// axis.
double move(std::uint64_t vertex, std::uint64_t attempt, int axis, int reach) {
  std::uint64_t x =
      vertex * 0x9e3779b97f4a7c15u + attempt * 0xbf58476d1ce4e5b9u + static_cast<std::uint64_t>(axis);
  x ^= x >> 31, x *= 0x94d049bb133111ebu, x ^= x >> 29;
  return static_cast<double>(static_cast<int>(x % static_cast<std::uint64_t>(2 * reach + 1)) - reach);
}

/// The vertex moved outwards, so that b overlaps what it only touched, and a little in a pseudo-random
/// direction, so that it does not come to touch something else.
Point2 moved_vertex(const Polygon& b, Slot s, std::size_t attempt, int reach) {
  const Point2 in = b.at(s) - b.at(b.prev(s)), out = b.end(s) - b.at(s);
  const Point2 along = (1 / std::sqrt(squared_length(in))) * in + (1 / std::sqrt(squared_length(out))) * out;
  const double length = std::sqrt(squared_length(along));
  const Point2 right = length > 0 ? (reach / length) * Point2{along.y, -along.x} : Point2{};
  const std::uint64_t v = b.node(s).edge.value;
  const int aside = (reach + 1) / 2;
  return round_to_grid(b.at(s) + right + Point2{move(v, attempt, 0, aside), move(v, attempt, 1, aside)});
}

int orientation_of(const std::vector<NewVertex>& cycle) {
  std::vector<Point2> points;
  for (const NewVertex& v : cycle) points.push_back(v.at);
  return chain_orientation(points);
}

/// b's edges, with its vertices moved; none when that would make b invalid.
std::vector<SourceEdge> edges_of(const Polygon& b, std::size_t attempt, double gap) {
  const int reach = reach_of(attempt, gap);
  std::vector<std::vector<NewVertex>> cycles;
  std::vector<SourceEdge> edges;
  for (const auto& cycle : b.cycles()) {
    if (cycle.size == 0) continue;
    auto& moved = cycles.emplace_back(b.vertices(cycle));
    Slot s = cycle.first;
    for (std::size_t i = 0; reach > 0 && i < moved.size(); ++i, s = b.next(s))
      moved[i].at = moved_vertex(b, s, attempt, reach);
    for (std::size_t i = 0; i < moved.size(); ++i, s = b.next(s))
      edges.push_back({moved[i].at, moved[(i + 1) % moved.size()].at, s, b.next(s)});
  }
  std::stable_sort(cycles.begin(), cycles.end(),
                   [](const auto& c, const auto& d) { return orientation_of(c) > orientation_of(d); });
  if (reach > 0 && judge_cycles(cycles) != Verdict::valid) edges.clear();
  return edges;
}

bool near(Point2 p, Point2 q) { return squared_length(p - q) < 4; }

/// Makes the union a few steps wide where it is thinner than a step: where b touches a, or crosses a part of
/// a that is so thin, vertices of its outlines that do not follow each other round to nearly the same point.
/// Each of them is moved along its edge of b, away from the others.
class Widening {
 public:
  explicit Widening(std::vector<Outline>& outlines) : outlines_(outlines) {
    for (std::size_t k = 0; k < outlines.size(); ++k)
      for (std::size_t i = 0; i < outlines[k].pieces.size(); ++i)
        places_.push_back({outlines[k].pieces[i].at, k, i});
    std::sort(places_.begin(), places_.end(), [](const Place& p, const Place& q) {
      return std::tuple(p.at.x, p.at.y, p.outline, p.piece) < std::tuple(q.at.x, q.at.y, q.outline, q.piece);
    });
  }

  void widen() {
    std::vector<std::pair<OutlinePiece*, Point2>> moves;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      bool meets = false;
      for (std::size_t j = i; j-- > 0 && places_[j].at.x > places_[i].at.x - 2 && !meets;)
        meets = meet(places_[i], places_[j]);
      for (std::size_t j = i + 1; j < places_.size() && places_[j].at.x < places_[i].at.x + 2 && !meets; ++j)
        meets = meet(places_[i], places_[j]);
      if (!meets) continue;
      if (const auto to = moved(places_[i])) moves.emplace_back(&piece(places_[i], 0), *to);
    }
    for (const auto& [piece, to] : moves) piece->at = to;
  }

 private:
  struct Place {
    Point2 at;
    std::size_t outline, piece;
  };

  OutlinePiece& piece(const Place& p, std::ptrdiff_t ahead) const {
    auto& pieces = outlines_[p.outline].pieces;
    const auto n = static_cast<std::ptrdiff_t>(pieces.size());
    return pieces[static_cast<std::size_t>((static_cast<std::ptrdiff_t>(p.piece) + ahead + n) % n)];
  }

  /// Are they near each other without being consecutive on an outline?
  bool meet(const Place& p, const Place& q) const {
    if (!near(p.at, q.at)) return false;
    return &piece(p, 1) != &piece(q, 0) && &piece(q, 1) != &piece(p, 0);
  }

  std::optional<Point2> moved(const Place& p) const {
    constexpr double kWidth = 3;  // steps
    const bool open = outlines_[p.outline].end != kNoSlot;
    const bool first = p.piece == 0, last = p.piece + 1 == outlines_[p.outline].pieces.size();
    if (piece(p, 0).vertex != kNoSlot || (open && (first || last))) return std::nullopt;
    const bool in_b = piece(p, -1).edge_b != kNoSlot, out_b = piece(p, 0).edge_b != kNoSlot;
    if (in_b == out_b) return std::nullopt;
    const Point2 way = piece(p, in_b ? -1 : 1).at - p.at;
    const double length = std::sqrt(squared_length(way));
    if (length < 4 * kWidth) return std::nullopt;
    return round_to_grid(p.at + (kWidth / length) * way);
  }

  std::vector<Outline>& outlines_;
  std::vector<Place> places_;
};

/// Turns the outlines of the union into an edit of a: edges of a that survive whole stay, what lies between
/// them on an outline becomes a chain, and an outline without any such edge becomes a loop.
class Candidate {
 public:
  Candidate(const Polygon& a, const Polygon& b, const Gap& gap, bool moved)
      : a_(a), b_(b), gap_(gap), moved_(moved) {}

  void add(const Outline& outline) {
    const auto& pieces = outline.pieces;
    const std::size_t n = pieces.size();
    const bool open = outline.end != kNoSlot;
    const auto after = [&](std::size_t i) {
      return open && i + 1 == n ? outline.end : pieces[(i + 1) % n].vertex;
    };
    std::vector<char> kept(n);
    for (std::size_t i = 0; i < n; ++i) {
      const OutlinePiece& p = pieces[i];
      kept[i] = p.vertex != kNoSlot && p.edge_a == p.vertex && after(i) == a_.next(p.vertex);
    }
    const bool untouched = std::find(kept.begin(), kept.end(), 0) == kept.end();
    if (!open && !untouched && vanishes(pieces)) return;
    for (std::size_t i = 0; i < n; ++i)
      if (kept[i]) kept_edges_.push_back(pieces[i].vertex);
    std::size_t first = 0;
    if (!open) {
      while (first < n && !kept[first]) ++first;
      if (first == n) return add_loop(pieces);
    }
    for (std::size_t k = 0; k < n; ++k) {
      std::size_t i = (first + k) % n;
      if (kept[i]) continue;
      const NewVertex start = vertex_of(pieces, i);
      Chain chain{pieces[i].vertex, {}, kNoSlot, start.edge, start.shared};
      for (++k; k < n && !kept[(first + k) % n]; ++k) chain.via.push_back(vertex_of(pieces, (first + k) % n));
      chain.to = k < n ? pieces[(first + k) % n].vertex : open ? outline.end : pieces[first].vertex;
      if (chain.from == kNoSlot || chain.to == kNoSlot)
        broken_ = true;
      else
        edit_.chains.push_back(std::move(chain));
    }
  }

  /// The edit, without vertices closer than two steps to the one before; nothing when a chain of it would not
  /// begin and end at vertices of a.
  std::optional<Edit> finish(const std::vector<SourceEdge>& window_edges) {
    if (broken_) return std::nullopt;
    std::sort(kept_edges_.begin(), kept_edges_.end());
    std::vector<CycleId> gone;
    for (const SourceEdge& e : window_edges) {
      const CycleId id = a_.node(e.slot).cycle;
      const bool kept = std::binary_search(kept_edges_.begin(), kept_edges_.end(), e.slot);
      if (!kept && std::find(gone.begin(), gone.end(), id) == gone.end()) gone.push_back(id);
    }
    for (Chain& c : edit_.chains) {
      drop_near(c);
      std::erase(gone, a_.node(c.from).cycle);
    }
    edit_.removed_cycles = std::move(gone);
    return std::move(edit_);
  }

 private:
  NewVertex vertex_of(const std::vector<OutlinePiece>& pieces, std::size_t i) const {
    const OutlinePiece& p = pieces[i];
    NewVertex v{p.at};
    const OutlinePiece& q = pieces[(i + 1) % pieces.size()];
    const bool whole = p.edge_b != kNoSlot && !moved_ && p.at == b_.at(p.edge_b) && q.at == b_.end(p.edge_b);
    if (whole) v.edge = b_.node(p.edge_b).edge, v.shared = b_.node(p.edge_b).shared;
    return v;
  }

  /// Is the outline a hole that collapses, because it is narrower than the resolution?
  bool vanishes(const std::vector<OutlinePiece>& pieces) const {
    std::vector<NewVertex> loop;
    for (const OutlinePiece& p : pieces) loop.push_back({p.at});
    if (orientation_of(loop) > 0) return false;
    drop_near(loop);
    std::vector<Point2> points;
    for (const NewVertex& v : loop) points.push_back(v.at);
    return collapses(points, gap_.at(points.front()));
  }

  void add_loop(const std::vector<OutlinePiece>& pieces) {
    std::vector<NewVertex> loop;
    for (std::size_t i = 0; i < pieces.size(); ++i) loop.push_back(vertex_of(pieces, i));
    drop_near(loop);
    edit_.loops.push_back(std::move(loop));
  }

  void drop_near(Chain& chain) const {
    NewVertex start{a_.at(chain.from), chain.edge, chain.shared};
    drop_near(start, chain.via, a_.at(chain.to));
    chain.edge = start.edge, chain.shared = start.shared;
  }

  static void drop_near(std::vector<NewVertex>& loop) {
    if (loop.empty()) return;
    std::vector<NewVertex> rest(loop.begin() + 1, loop.end());
    drop_near(loop.front(), rest, loop.front().at);
    loop.resize(1);
    loop.insert(loop.end(), rest.begin(), rest.end());
  }

  /// Drops vertices closer than two steps to the one before, and at the end those as close to `to`. The edge
  /// before a dropped vertex is a new edge, so it loses its identity.
  static void drop_near(NewVertex& start, std::vector<NewVertex>& via, Point2 to) {
    std::vector<NewVertex> result;
    const auto last = [&]() -> NewVertex& { return result.empty() ? start : result.back(); };
    const auto drop_after_last = [&] { last().edge = {}, last().shared = false; };
    for (const NewVertex& v : via) {
      if (near(v.at, last().at))
        drop_after_last();
      else
        result.push_back(v);
    }
    while (!result.empty() && near(result.back().at, to)) {
      result.pop_back();
      drop_after_last();
    }
    via = std::move(result);
  }

  const Polygon &a_, &b_;
  const Gap& gap_;
  bool moved_;
  Edit edit_;
  std::vector<Slot> kept_edges_;
  bool broken_ = false;
};

std::vector<SourceEdge> window_edges_of(const Polygon& a, const Box2& window) {
  std::vector<Slot> slots;
  a.any_edge_near(window, [&](Slot s) { return slots.push_back(s), false; });
  std::sort(slots.begin(), slots.end());
  slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
  std::vector<SourceEdge> edges;
  for (const Slot s : slots) edges.push_back({a.at(s), a.end(s), s, a.next(s)});
  return edges;
}

}  // namespace

bool unite(Polygon& a, const Polygon& b, const Gap& gap, EdgeIds& ids, std::size_t* attempts) {
  for (std::size_t attempt = 0; attempt < kMoves.size(); ++attempt) {
    if (attempts) *attempts = attempt + 1;
    const auto edges_b = edges_of(b, attempt, gap.at(b.at(b.outer().first)));
    if (edges_b.empty()) continue;
    Box2 box;
    for (const SourceEdge& e : edges_b) box.add(e.a);
    // The border lies half a step off the grid, so that no vertex is on it.
    const Box2 window{{std::floor(box.low.x) - 1.5, std::floor(box.low.y) - 1.5},
                      {std::ceil(box.high.x) + 1.5, std::ceil(box.high.y) + 1.5}};
    const auto edges_a = window_edges_of(a, window);
    std::vector<int> sides;
    for (const Point2 c : internal::corners(window)) {
      const auto side = a.locate(c);
      sides.push_back(side == Polygon::Side::inside ? 1 : side == Polygon::Side::outside ? -1 : 0);
    }
    std::vector<Outline> outlines;
    if (!internal::union_outlines(edges_a, edges_b, window, sides, outlines)) continue;
    Widening(outlines).widen();
    Candidate candidate(a, b, gap, attempt > 0);
    for (const Outline& o : outlines) candidate.add(o);
    const auto edit = candidate.finish(edges_a);
    if (!edit) continue;
    if (edit->chains.empty() && edit->loops.empty() && edit->removed_cycles.empty())
      return true;  // b inside a
    if (a.grow(*edit, ids) == Verdict::valid) return true;
  }
  return false;
}

}  // namespace limpet::geometry
