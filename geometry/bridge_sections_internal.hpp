// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include <limpet/geometry/predicates.hpp>
#include <limpet/geometry/search.hpp>

namespace limpet::geometry::internal {

inline constexpr std::size_t kMaxWalk = 256;
inline constexpr std::size_t kMaxAttempts = 24;

/// An end of section Q: a vertex of Y, or a point that divides an edge of Y.
struct Foot {
  Slot edge = kNoSlot;        ///< the vertex, or the edge that is divided
  std::optional<Point2> cut;  ///< where the edge is divided, rounded; none: the end is the vertex
  Point2 at;
  double position = 0;  ///< along Y from the contact's edge, in edges
};

/// A possible end of section P, with its nearest point on Y. It is a vertex, or a point that divides the edge
/// from the last vertex that is near enough to the next one. (The thesis leaves the latter out to save work;
/// but without them a spike, whose edges are long, could not be bridged to anything.)
struct SectionEnd {
  Slot kept;                  ///< the vertex at which the perimeter that stays begins or ends
  std::optional<Point2> cut;  ///< the end itself when it is not that vertex
  Foot foot;
};

/// A nearest pair of perimeter points.
struct Contact {
  PerimeterPoint x, y;
};

/// Searches for sections P of x and Q of y around a contact. x and y may be the same polygon.
class SectionSearch {
 public:
  SectionSearch(const Polygon& x, const Polygon& y, const Contact& contact, double gap)
      : x_(x), y_(y), contact_(contact), gap_(gap), self_(&x == &y) {
    walk_q();
  }

  /// Calls attempt(p1, p2) for the pairs that satisfy the conditions, P longest first, until one succeeds.
  template <class Attempt>
  bool search(Attempt&& attempt) const {
    const auto back = walk_p(false), forward = walk_p(true);
    const std::size_t size = x_.cycle(x_.node(contact_.x.edge).cycle).size;
    std::size_t attempts = 0;
    for (std::size_t total = back.size() + forward.size(); total-- > 0;)
      for (std::size_t i = std::min(total + 1, back.size()); i-- > 0;) {
        const std::size_t j = total - i;
        const std::size_t edges = i + j + (contact_.x.fraction == 0 ? 0 : 1);  // of P
        if (j >= forward.size() || edges == 0 || edges >= size) continue;
        if (!back[i] || !forward[j] || !ordered(forward[j]->foot, back[i]->foot)) continue;
        if (attempt(*back[i], *forward[j])) return true;
        if (++attempts == kMaxAttempts) return false;
      }
    return false;
  }

 private:
  struct Stretch {
    Slot edge;
    double offset;
  };

  /// Collects the edges of Y around the contact, in both directions for as long as vertices are within the
  /// gap of X.
  void walk_q() {
    const std::size_t size = y_.cycle(y_.node(contact_.y.edge).cycle).size;
    const std::size_t limit = std::min(self_ ? std::size_t{6} : kMaxWalk, size - 1);
    q_.push_back({contact_.y.edge, 0});
    Slot s = contact_.y.edge;
    for (std::size_t k = 1; k <= limit; ++k) {
      s = y_.next(s);
      if (kept(y_, s) || !near_x(y_.at(s))) break;
      q_.push_back({s, static_cast<double>(k)});
    }
    s = contact_.y.edge;
    for (std::size_t k = 1; k <= limit && near_x(y_.at(s)); ++k) {
      s = y_.prev(s);
      if (kept(y_, s)) break;
      q_.push_back({s, -static_cast<double>(k)});
    }
  }

  /// Within one polygon shared edges are kept; when two polygons merge, shared edges may be replaced.
  bool kept(const Polygon& polygon, Slot edge) const { return self_ && polygon.node(edge).shared; }

  bool near_x(Point2 p) const {
    if (self_) return squared_length(p - contact_.x.at) < 4 * gap_ * gap_;
    return nearest_perimeter_point(x_, p, gap_).has_value();
  }

  /// The possible ends of P in one direction, by the number of vertices between the end and the contact; none
  /// where the end does not sight its foot. The last one may be a cut.
  std::vector<std::optional<SectionEnd>> walk_p(bool forward) const {
    std::vector<std::optional<SectionEnd>> result;
    const std::size_t size = x_.cycle(x_.node(contact_.x.edge).cycle).size;
    const std::size_t limit = std::min(self_ ? std::size_t{3} : kMaxWalk, size - 1);
    // When the contact is a vertex, P may begin or end there.
    Slot s = forward && contact_.x.fraction > 0 ? x_.next(contact_.x.edge) : contact_.x.edge;
    Point2 inner = contact_.x.at;
    double inner_distance = std::sqrt(contact_.x.squared_distance);
    for (std::size_t k = 0; k < limit; ++k, s = forward ? x_.next(s) : x_.prev(s)) {
      if (k > 0 && kept(x_, forward ? x_.prev(s) : s)) break;
      const auto foot = nearest_on_q(x_.at(s), forward);
      if (!foot) {
        result.push_back(cut_towards(s, inner, inner_distance, forward));
        break;
      }
      const SectionEnd end{s, std::nullopt, *foot};
      // At the innermost vertex of an inlet the two sections meet: there is nothing to bridge.
      const bool bottom = foot->at == x_.at(s);
      result.push_back(!bottom && visible(end, forward) ? std::optional(end) : std::nullopt);
      inner = x_.at(s);
      inner_distance = std::sqrt(squared_length(foot->at - inner));
    }
    return result;
  }

  /// An end on the way from `inner`, at this distance from Q, to the vertex `outer`, which is too far from Q:
  /// as far along it as is certain to be within the gap.
  std::optional<SectionEnd> cut_towards(Slot outer, Point2 inner, double distance, bool forward) const {
    const Point2 d = x_.at(outer) - inner;
    const double length = std::sqrt(squared_length(d));
    const double way = std::min(gap_ - distance - 2, 0.9 * length);
    if (way < 8 || length - way < 8) return std::nullopt;  // no slivers
    const Point2 cut = round_to_grid(inner + (way / length) * d);
    const auto foot = nearest_on_q(cut, forward);
    if (!foot) return std::nullopt;
    const SectionEnd end{outer, cut, *foot};
    return visible(end, forward) ? std::optional(end) : std::nullopt;
  }

  /// The point nearest to p on the collected edges of Y. The foot of P's forward end is where Q begins, so it
  /// lies before the contact along Y; the foot of its backward end lies after it.
  std::optional<Foot> nearest_on_q(Point2 p, bool forward) const {
    std::optional<Foot> best;
    double best_d2 = gap_ * gap_;
    for (const Stretch& q : q_) {
      if (forward ? q.offset > 0 : q.offset < 0) continue;
      if (kept(y_, q.edge)) continue;
      const Point2 a = y_.at(q.edge), b = y_.end(q.edge);
      double t = nearest_fraction(a, b, p);
      if (q.offset == 0) t = forward ? std::min(t, contact_.y.fraction) : std::max(t, contact_.y.fraction);
      const Point2 at = a + t * (b - a);
      const double d2 = squared_length(at - p);
      if (d2 >= best_d2) continue;
      best_d2 = d2;
      const Point2 rounded = round_to_grid(at);
      if (rounded == a || t == 0)
        best = Foot{q.edge, std::nullopt, a, q.offset};
      else if (rounded == b || t == 1)
        best = Foot{y_.next(q.edge), std::nullopt, b, q.offset + 1};
      else
        best = Foot{q.edge, rounded, rounded, q.offset + t};
    }
    return best;
  }

  bool visible(const SectionEnd& end, bool forward) const {
    const Foot& foot = end.foot;
    const Slot cut_y = foot.cut ? foot.edge : kNoSlot;
    const Slot cut_x = end.cut ? (forward ? x_.prev(end.kept) : end.kept) : kNoSlot;
    const SightEnd p = end.cut ? SightEnd{*end.cut, kNoSlot} : SightEnd{x_.at(end.kept), end.kept};
    const SightEnd q{foot.at, foot.cut ? kNoSlot : foot.edge};
    if (self_) return sights(x_, p, q, {cut_x, cut_y});
    return sights(x_, p, {foot.at, kNoSlot}, {cut_x}) && sights(y_, {p.at, kNoSlot}, q, {cut_y});
  }

  /// Q runs from q1 (the foot of p2) to q2 (the foot of p1), not all the way round.
  bool ordered(const Foot& q1, const Foot& q2) const {
    const auto size = static_cast<double>(y_.cycle(y_.node(contact_.y.edge).cycle).size);
    return q1.position < q2.position && q2.position - q1.position <= size - (q1.cut && q2.cut ? 0 : 1);
  }

  const Polygon &x_, &y_;
  Contact contact_;
  double gap_;
  bool self_;
  std::vector<Stretch> q_;
};

}  // namespace limpet::geometry::internal
