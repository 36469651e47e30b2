// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/geometry/fissure.hpp>

#include <array>

#include <limpet/geometry/bridge.hpp>
#include <limpet/geometry/judge.hpp>
#include <limpet/geometry/predicates.hpp>
#include <limpet/geometry/search.hpp>

#include "fissure_internal.hpp"

namespace limpet::geometry {
namespace internal {
namespace {

bool within(Point2 a, Point2 b, double gap) { return squared_length(a - b) < gap * gap; }

/// The foot of the perpendicular from p on edge ab, rounded, if it is between the ends and within gap of p. A
/// foot within two steps of an end is not used: repeated fillings would follow the rounding of the foot
/// before, step by step, and turn a long edge inwards.
std::optional<Point2> foot_on(Point2 a, Point2 b, Point2 p, double gap) {
  const Point2 foot = round_to_grid(a + nearest_fraction(a, b, p) * (b - a));
  if (within(foot, a, 2) || within(foot, b, 2) || foot == p || !within(foot, p, gap)) return std::nullopt;
  return foot;
}

/// Types I to III at the vertices a, b, c; `last` is the index of c among the four.
std::optional<Filling> three(FissureType type, Point2 a, Point2 b, Point2 c, double gap, std::size_t last) {
  if (orientation(a, b, c) >= 0) return std::nullopt;  // the outside is on the right, so an inlet turns right
  if (type == FissureType::I) {
    if (!within(a, c, gap)) return std::nullopt;
    return Filling{type, 0, last, std::nullopt};
  }
  if (dot(a - b, c - b) <= 0) return std::nullopt;
  const auto foot = type == FissureType::II ? foot_on(b, c, a, gap) : foot_on(a, b, c, gap);
  if (!foot) return std::nullopt;
  return Filling{type, 0, last, foot};
}

}  // namespace

Filling::Region Filling::region(const std::array<Point2, 4>& v) const {
  const bool foot_first = type == FissureType::III || type == FissureType::VI;
  const bool foot_last = type == FissureType::II || type == FissureType::V;
  Region points{foot_first ? *foot : v[0]};
  for (std::size_t i = 1; i < last; ++i) points.push_back(v[i]);
  points.push_back(foot_last ? *foot : v[last]);
  return points;
}

std::optional<Filling> find_fissure(FissureType type, const std::array<Point2, 4>& v, double gap) {
  switch (type) {
    case FissureType::I:
    case FissureType::II:
    case FissureType::III:
      return three(type, v[0], v[1], v[2], gap, 2);
    case FissureType::IV: {
      if (!within(v[1], v[2], gap) || !within(v[0], v[3], gap)) return std::nullopt;
      // The external angle between v1v2 and v3v4 is below 180° when v1 v2 v3 v4 is clockwise on the whole.
      const double area = cross(v[1] - v[0], v[2] - v[0]) + cross(v[2] - v[0], v[3] - v[0]);
      if (area >= 0) return std::nullopt;
      return Filling{type, 0, 3, std::nullopt};
    }
    case FissureType::V: {
      if (!within(v[1], v[2], gap)) return std::nullopt;
      auto filling = three(FissureType::II, v[0], v[2], v[3], gap, 3);
      if (filling) filling->type = type;
      return filling;
    }
    case FissureType::VI: {
      if (!within(v[1], v[2], gap)) return std::nullopt;
      auto filling = three(FissureType::III, v[0], v[1], v[3], gap, 3);
      if (filling) filling->type = type;
      return filling;
    }
  }
  return std::nullopt;
}

}  // namespace internal

namespace {

using internal::Filling;
using internal::FissureType;

bool needs_four(FissureType t) { return t == FissureType::IV || t == FissureType::V || t == FissureType::VI; }

class Filler {
 public:
  Filler(Polygon& polygon, const Gap& gap, EdgeIds& ids, bool bridge, const MayFill& may_fill)
      : polygon_(polygon), gap_(gap), ids_(ids), bridge_(bridge), may_fill_(may_fill) {}

  std::size_t run(std::span<const std::pair<Slot, EdgeId>> fresh) {
    queue_.assign(fresh.begin(), fresh.end());
    // Every filling adds area and shortens the perimeter, so this terminates; the bound is for the float
    // builds.
    std::size_t budget = 1000 + 40 * queue_.size();
    for (std::size_t done = 0; done < queue_.size() && budget-- > 0; ++done) {
      const auto [slot, edge] = queue_[done];
      if (!current(slot, edge)) continue;
      Slot v1 = polygon_.prev(polygon_.prev(slot));
      bool filled = false;
      for (int k = 0; k < 3 && !filled; ++k, v1 = polygon_.next(v1)) filled = fill_at(v1);
      if (!filled && bridge_ && current(slot, edge)) filled = bridge_at(slot);
      if (filled && current(slot, edge)) queue_.emplace_back(slot, edge);
      count_ += filled;
    }
    return count_;
  }

 private:
  bool current(Slot slot, EdgeId edge) const {
    return polygon_.alive(slot) && polygon_.node(slot).edge == edge;
  }

  bool fill_at(Slot v1) {
    const std::array<Slot, 4> s = {v1, polygon_.next(v1), polygon_.next(polygon_.next(v1)),
                                   polygon_.next(polygon_.next(polygon_.next(v1)))};
    if (polygon_.node(s[0]).shared || polygon_.node(s[1]).shared) return false;
    const auto& cycle = polygon_.cycle(polygon_.node(v1).cycle);
    const bool four = cycle.size >= 4 && !polygon_.node(s[2]).shared;
    std::array<Point2, 4> v;
    for (std::size_t i = 0; i < 4; ++i) v[i] = polygon_.at(s[i]);
    const double gap = gap_.at(v[1]);
    const bool narrow = four && squared_length(v[2] - v[1]) < gap * gap;
    for (const FissureType type : internal::kFissureOrder) {
      if ((needs_four(type) && !narrow) || !possible(type, v, gap)) continue;
      if (const auto filling = internal::find_fissure(type, v, gap);
          filling && may_add(filling->region(v)) && fill(s, *filling, cycle))
        return true;
    }
    return false;
  }

  /// The conditions of find_fissure() that are cheap, and that most vertices fail.
  static bool possible(FissureType type, const std::array<Point2, 4>& v, double gap) {
    const auto within = [&](Point2 a, Point2 b) { return squared_length(a - b) < gap * gap; };
    const auto acute_notch = [](Point2 a, Point2 b, Point2 c) {
      return dot(a - b, c - b) > 0 && orientation(a, b, c) < 0;
    };
    switch (type) {
      case FissureType::I:
        return within(v[0], v[2]) && orientation(v[0], v[1], v[2]) < 0;
      case FissureType::II:
      case FissureType::III:
        return acute_notch(v[0], v[1], v[2]);
      case FissureType::IV:
        return within(v[0], v[3]);
      case FissureType::V:
        return acute_notch(v[0], v[2], v[3]);
      case FissureType::VI:
        return acute_notch(v[0], v[1], v[3]);
    }
    return false;
  }

  /// Is the region simple and on the outside of the perimeter, so that the ends of the new edge sight each
  /// other along the removed edges?
  static bool lies_outside(const Filling::Region& region) {
    internal::SmallVector<KeyedEdge, 4> edges;
    for (std::size_t i = 0; i < region.size(); ++i) {
      const std::size_t j = (i + 1) % region.size();
      edges.push_back({region[i], region[j], i, j});
    }
    return judge_edges(internal::as_span(edges)) == Verdict::valid &&
           chain_orientation(internal::as_span(region)) < 0;
  }

  bool may_add(const Filling::Region& region) const {
    return lies_outside(region) && (!may_fill_ || may_fill_(internal::as_span(region)));
  }

  bool fill(const std::array<Slot, 4>& s, const Filling& filling, const Polygon::Cycle& cycle) {
    const std::size_t left = cycle.size - (filling.last - 1) + (filling.foot ? 1 : 0);
    Edit edit;
    if (left < 3 || s[filling.first] == s[filling.last]) {
      if (!cycle.hole || any_shared(cycle)) return false;
      edit.removed_cycles.push_back(polygon_.node(s[0]).cycle);  // collapsed
    } else {
      Chain chain{s[filling.first], {}, s[filling.last]};
      if (filling.foot) chain.via.push_back({*filling.foot});
      edit.chains.push_back(std::move(chain));
    }
    return commit(edit);
  }

  bool any_shared(const Polygon::Cycle& cycle) const {
    const auto vertices = polygon_.vertices(cycle);
    return std::any_of(vertices.begin(), vertices.end(), [](const NewVertex& v) { return v.shared; });
  }

  bool bridge_at(Slot slot) {
    const std::size_t before = polygon_.version();
    if (!bridge_self(polygon_, slot, gap_.at(polygon_.at(slot)), ids_)) return false;
    enqueue_created();
    return polygon_.version() != before;
  }

  bool commit(const Edit& edit) {
    if (polygon_.grow(edit, ids_) != Verdict::valid) return false;
    enqueue_created();
    return true;
  }

  void enqueue_created() {
    for (; read_ < polygon_.created().size(); ++read_) queue_.push_back(polygon_.created()[read_]);
  }

  Polygon& polygon_;
  const Gap& gap_;
  EdgeIds& ids_;
  bool bridge_;
  const MayFill& may_fill_;
  std::vector<std::pair<Slot, EdgeId>> queue_;    ///< the worklist of edges; those examined stay in it
  std::size_t read_ = polygon_.created().size();  ///< of the edges put in place, so many are in the worklist
  std::size_t count_ = 0;
};

}  // namespace

std::size_t fill_fissures(Polygon& polygon, std::span<const std::pair<Slot, EdgeId>> fresh, const Gap& gap,
                          EdgeIds& ids, bool bridge, const MayFill& may_fill) {
  return Filler(polygon, gap, ids, bridge, may_fill).run(fresh);
}

bool collapses(std::vector<Point2> chain, double gap) {
  std::size_t idle = 0;
  std::size_t budget = 64 * chain.size() + 64;
  for (std::size_t i = 0; chain.size() >= 3 && idle < chain.size() && budget-- > 0;) {
    const std::size_t n = chain.size();
    std::array<Point2, 4> v;
    for (std::size_t k = 0; k < 4; ++k) v[k] = chain[(i + k) % n];
    bool filled = false;
    for (const FissureType type : internal::kFissureOrder) {
      if (needs_four(type) && n < 4) continue;
      const auto filling = internal::find_fissure(type, v, gap);
      if (!filling) continue;
      std::vector<Point2> rest;  // from `last` around the chain to `first`, then the foot
      for (std::size_t k = filling->last; k <= n; ++k) rest.push_back(chain[(i + k) % n]);
      if (filling->foot) rest.push_back(*filling->foot);
      chain = std::move(rest);
      i = chain.size() >= 3 ? chain.size() - 3 : 0;
      filled = true;
      break;
    }
    if (filled) {
      idle = 0;
      continue;
    }
    ++idle;
    i = (i + 1) % n;
  }
  return chain.size() < 3;
}

}  // namespace limpet::geometry
