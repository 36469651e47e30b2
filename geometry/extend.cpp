// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/geometry/extend.hpp>

#include <array>
#include <cmath>

#include <limpet/geometry/predicates.hpp>
#include <limpet/geometry/search.hpp>

#include "small_vector_internal.hpp"

namespace limpet::geometry {
namespace {

constexpr std::size_t kMaxAttempts = 12;

/// A possible end of the section, if it sights the new point: a vertex, or a point that divides the edge next
/// to it.
struct ExtensionEnd {
  Slot vertex = kNoSlot;          ///< the last vertex kept before the section, or the first one after it
  Slot edge = kNoSlot;            ///< that is divided
  std::optional<Point2> cut;      ///< the end itself when it is not that vertex
  double length = 0;              ///< along the perimeter from the nearest point
  std::size_t steps = 0;          ///< vertices passed since the nearest edge
  std::optional<bool> sighted{};  ///< once it has been asked
};

using Ends = internal::SmallVector<ExtensionEnd, 8>;

/// Where the line from `inner`, within gap of q, to `outer`, farther away, leaves the disc around q; nothing
/// when that is too near to one of its ends.
std::optional<Point2> leaving_point(Point2 inner, Point2 outer, Point2 q, double gap) {
  const Point2 d = outer - inner, m = inner - q;
  const double a = squared_length(d), b = dot(m, d), c = squared_length(m) - gap * gap;
  const double root = std::sqrt(std::max(0.0, b * b - a * c));
  const double t = a > 0 ? (root - b) / a : 0;
  // Two steps inside the disc, so that rounding does not carry it out.
  const Point2 p = round_to_grid(inner + std::max(0.0, t - 2 / std::sqrt(a)) * d);
  const double keep_off = 16;  // four steps, squared: shorter edges would be slivers
  if (squared_length(p - inner) < keep_off || squared_length(p - outer) < keep_off) return std::nullopt;
  return p;
}

class ExtensionSearch {
 public:
  ExtensionSearch(const Polygon& polygon, Point2 q, double gap, const PerimeterPoint& nearest)
      : polygon_(polygon), q_(q), gap_(gap), nearest_(nearest) {}

  Ends ends(bool forward) const {
    Ends result;
    const std::size_t limit = polygon_.cycle(polygon_.node(nearest_.edge).cycle).size;
    Slot edge = nearest_.edge;
    Point2 inner = nearest_.at;
    double length = 0;
    for (std::size_t steps = 0; steps < limit; ++steps) {
      if (polygon_.node(edge).shared) break;
      const Slot outer = forward ? polygon_.next(edge) : edge;
      const Point2 at = polygon_.at(outer);
      if (squared_length(at - q_) >= gap_ * gap_) {
        if (const auto cut = leaving_point(inner, at, q_, gap_))
          result.push_back({outer, edge, cut, length + std::sqrt(squared_length(*cut - inner)), steps});
        break;
      }
      length += std::sqrt(squared_length(at - inner));
      result.push_back({outer, kNoSlot, std::nullopt, length, steps});
      inner = at;
      edge = forward ? outer : polygon_.prev(outer);
    }
    return result;
  }

  /// Asked of the longest sections first, few of which fail.
  bool sighted(ExtensionEnd& end) const {
    if (!end.sighted) {
      const SightEnd from =
          end.cut ? SightEnd{*end.cut, kNoSlot} : SightEnd{polygon_.at(end.vertex), end.vertex};
      end.sighted = sights(polygon_, from, {q_, kNoSlot}, {end.edge});
    }
    return *end.sighted;
  }

 private:
  const Polygon& polygon_;
  Point2 q_;
  double gap_;
  const PerimeterPoint& nearest_;
};

Edit edit_for(const ExtensionEnd& p1, const ExtensionEnd& p2, Point2 q) {
  Chain chain{p1.vertex, {}, p2.vertex};
  chain.via.reserve(3);
  if (p1.cut) chain.via.push_back({*p1.cut});
  chain.via.push_back({q});
  if (p2.cut) chain.via.push_back({*p2.cut});
  Edit edit;
  edit.chains.push_back(std::move(chain));
  return edit;
}

}  // namespace

Extension extend_to_point(Polygon& polygon, Point2 q, double gap, EdgeIds& ids) {
  if (polygon.locate(q) != Polygon::Side::outside) return Extension::contained;
  const auto nearest = nearest_perimeter_point(polygon, q, gap);
  return nearest ? extend_from(*nearest, polygon, q, gap, ids) : Extension::refused;
}

Extension extend_from(const PerimeterPoint& nearest, Polygon& polygon, Point2 q, double gap, EdgeIds& ids) {
  if (polygon.node(nearest.edge).shared) return Extension::shared;
  const ExtensionSearch search(polygon, q, gap, nearest);
  auto back = search.ends(false), forward = search.ends(true);
  const std::size_t size = polygon.cycle(polygon.node(nearest.edge).cycle).size;

  // Longest sections first. On a small perimeter the two ends must not pass each other on the far side.
  struct Pair {
    double length;
    std::size_t i, j;
  };
  internal::SmallVector<Pair, 32> pairs;
  for (std::size_t i = 0; i < back.size(); ++i)
    for (std::size_t j = 0; j < forward.size(); ++j) {
      const std::size_t passed = back[i].steps + forward[j].steps;
      // With both ends cut, the edge between the two kept vertices must itself be kept.
      if (passed + 2 > size || (passed + 2 == size && (back[i].cut || forward[j].cut) && size < 4)) continue;
      pairs.push_back({back[i].length + forward[j].length, i, j});
    }
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return a.length != b.length ? a.length > b.length : std::pair(a.i, a.j) < std::pair(b.i, b.j);
  });
  std::size_t attempts = 0;
  for (const Pair& pair : pairs) {
    ExtensionEnd &p1 = back[pair.i], &p2 = forward[pair.j];
    if (!search.sighted(p1) || !search.sighted(p2)) continue;
    if (polygon.grow(edit_for(p1, p2, q), ids) == Verdict::valid) return Extension::extended;
    if (++attempts == kMaxAttempts) break;
  }
  return Extension::refused;
}

}  // namespace limpet::geometry
